// A rated format as JSON.
#include "choosing/PredictionFigures.h"

#include "voxc/Search/SpeedModel.h"

namespace voxc::tool {

Json predictionFigures(const PredictedFormat &format, std::span<const std::string> sets) {
  Json figures;
  figures["format"] = format.candidate.text;
  figures["passes"] = format.candidate.passes;
  figures["words"] = format.price.words();
  figures["level_words"] = format.price.levelWords;
  figures["exact"] = format.price.exact;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const RayCost &cost = format.costs[set];
    figures["rays"][sets[set]] = {{"lookups", cost.lookups},
                                  {"turns", cost.turns},
                                  {"waits", cost.waits},
                                  {"words", cost.words},
                                  {"layers", cost.layers},
                                  {"packet_layers", cost.packetLayers},
                                  {"packet_trees", cost.packetTrees},
                                  {"marches", cost.marches},
                                  {"switches", cost.switches},
                                  {"packet_switches", cost.packetSwitches},
                                  {"lines", cost.lines},
                                  {"probes", cost.probes},
                                  {"colours", cost.colours},
                                  {"levels", cost.levels},
                                  {"binned", cost.binned},
                                  {"terms", speedTerms(cost, format.bytes())},
                                  {"nanoseconds", format.nanoseconds[set]}};
  }
  return figures;
}

} // namespace voxc::tool
