// The facts of a source as JSON.
#include "choosing/FactsFigures.h"

#include "voxc/Facts/Recommendations.h"

#include <array>

namespace voxc::tool {

namespace {

Json figuresOf(const DistinctCount &count) { return {{"count", count.count}, {"exact", count.exact}}; }

Json figuresOf(Int3 cell) { return {cell.x, cell.y, cell.z}; }

Json heightFigures(const Facts &facts) {
  Json rows = Json::array();
  for (std::size_t height = 0; height < facts.heights.size(); ++height) {
    const HeightFacts &cubes = facts.heights[height];
    rows.push_back({{"height", height},
                    {"occupied", cubes.occupied},
                    {"full", cubes.full},
                    {"one_colour", cubes.oneColour},
                    {"uniform", cubes.uniform},
                    {"branching", facts.branching(static_cast<int>(height))}});
  }
  return rows;
}

Json colourFigures(const ColourFacts &colours) {
  constexpr std::array<const char *, 4> kChannels{"r", "g", "b", "a"};
  Json channels;
  for (std::size_t i = 0; i < kChannels.size(); ++i)
    channels[kChannels[i]] = {{"least", colours.channels[i].least},
                              {"greatest", colours.channels[i].greatest},
                              {"mean", colours.channels[i].mean}};
  return {{"words", figuresOf(colours.words)},
          {"rgb", figuresOf(colours.rgb)},
          {"index_bits", colours.indexBits()},
          {"entropy", colours.entropy},
          {"entropy_exact", colours.entropyExact},
          {"channels", channels},
          {"alphas", colours.alphas},
          {"opaque", colours.opaque},
          {"transparent", colours.transparent},
          {"repeats", colours.repeats},
          {"per_block_4", colours.perBlock4},
          {"per_block_8", colours.perBlock8},
          {"per_run_256", colours.perRun256}};
}

Json repetitionFigures(const std::vector<RepetitionFacts> &repetition) {
  Json rows = Json::array();
  for (const RepetitionFacts &blocks : repetition)
    rows.push_back({{"height", blocks.height},
                    {"blocks", blocks.blocks},
                    {"shapes", figuresOf(blocks.shapes)},
                    {"mirrored", figuresOf(blocks.mirrored)},
                    {"coloured", figuresOf(blocks.coloured)}});
  return rows;
}

Json recommendationFigures(const Facts &facts) {
  Json rows = Json::array();
  for (const Recommendation &recommendation : recommend(facts))
    rows.push_back({{"rule", recommendation.rule}, {"text", recommendation.text}});
  return rows;
}

} // namespace

Json factsFigures(const Facts &facts) {
  return {{"extent", figuresOf(facts.extent)},
          {"log2_extent", facts.log2Extent},
          {"voxels", facts.voxels},
          {"box", {{"low", figuresOf(facts.boxLow)}, {"high", figuresOf(facts.boxHigh)}}},
          {"fill", facts.fill()},
          {"interior", facts.interior},
          {"heights", heightFigures(facts)},
          {"regions", {{"log2_side", facts.regions.log2Side}, {"voxels", facts.regions.voxels}}},
          {"colours", colourFigures(facts.colours)},
          {"repetition", repetitionFigures(facts.repetition)},
          {"recommendations", recommendationFigures(facts)}};
}

} // namespace voxc::tool
