// Findings as text.
#include "Finding.h"

#include <cstdio>

namespace voxc::cliffs {

tool::Json toJson(const Finding &finding) {
  const Situation &situation = finding.situation;
  tool::Json json{
      {"situation", situation.number},
      {"place", describe(finding.place)},
      {"rays", describe(situation)},
      {"device", finding.machine},
      {"ratio", finding.ratio()},
      {"nanoseconds", finding.rayNanoseconds()},
      {"expected_nanoseconds", finding.expected.nanoseconds / static_cast<double>(situation.count)},
      {"first_call_ratio", finding.cost.firstNanoseconds / finding.expected.nanoseconds},
      {"lookups", finding.lookups},
      {"expected_lookups", finding.expected.lookups},
      {"exact_steps", finding.exactSteps},
      {"visits", finding.expected.visits},
      {"allocations", finding.cost.allocations},
      {"page_faults", finding.cost.faults},
      {"compared", finding.compared},
      {"wrong", finding.wrong}};
  if (finding.peer) {
    json["peer_nanoseconds"] = *finding.peer;
    json["peer_ratio"] = finding.rayNanoseconds() / *finding.peer;
  }
  if (finding.movedOff)
    json["moved_off_nanoseconds"] = *finding.movedOff;
  return json;
}

std::string caseLine(const Finding &finding) {
  char counts[160];
  std::snprintf(counts, sizeof counts, "%llu\t%s\t%.3f\t%.3f\t%llu\t",
                static_cast<unsigned long long>(finding.situation.number), finding.machine.c_str(),
                finding.lookups, finding.exactSteps,
                static_cast<unsigned long long>(finding.cost.allocations));
  return counts + describe(finding.place) + "\t" + describe(finding.situation);
}

} // namespace voxc::cliffs
