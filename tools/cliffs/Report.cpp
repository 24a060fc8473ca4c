// Tables of findings.
#include "Report.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace voxc::cliffs {
namespace {

constexpr double kCliff = 2;

/// What a finding is an example of.
std::vector<std::string> kindsOf(const Finding &finding) {
  const Situation &situation = finding.situation;
  const std::size_t edge = static_cast<std::size_t>(
      std::max({finding.place.extent.x, finding.place.extent.y, finding.place.extent.z}));
  std::vector<std::string> kinds{"device " + finding.machine, "rays " + situation.rays,
                                 "count " + std::to_string(situation.count), "scene " + finding.place.scene,
                                 edge <= 16    ? "edge to 16"
                                 : edge <= 512 ? "edge to 512"
                                               : "edge above 512"};
  kinds.push_back("query " + std::string(kEnumNames<Query>[static_cast<std::size_t>(situation.query)]));
  kinds.push_back("interval " + std::string(nameOf(situation.interval)));
  if (situation.threads > 1)
    kinds.emplace_back("2 threads");
  if (situation.instances > 0)
    kinds.push_back("instances " + std::to_string(situation.instances));
  if (situation.isPaged)
    kinds.emplace_back("paged");
  return kinds;
}

void printKinds(const std::vector<Finding> &findings) {
  std::map<std::string, std::vector<const Finding *>> kinds;
  for (const Finding &finding : findings)
    for (const std::string &kind : kindsOf(finding))
      kinds[kind].push_back(&finding);
  std::printf("\n%-24s %6s %8s %8s %8s %8s  %s\n", "kind", "number", "above 2", "of both", "median", "worst",
              "situation");
  for (auto &[kind, members] : kinds) {
    std::ranges::sort(members, {}, &Finding::ratio);
    const auto above = std::ranges::count_if(members, [](const Finding *f) { return f->ratio() > kCliff; });
    const auto ofBoth =
        std::ranges::count_if(members, [](const Finding *f) { return f->leastRatio() > kCliff; });
    std::printf("%-24s %6zu %8td %8td %8.2f %8.2f  %llu\n", kind.c_str(), members.size(), above, ofBoth,
                members[members.size() / 2]->ratio(), members.back()->ratio(),
                static_cast<unsigned long long>(members.back()->situation.number));
  }
}

std::string toString(const std::optional<double> &nanoseconds) {
  char text[24] = "";
  if (nanoseconds)
    std::snprintf(text, sizeof text, "%.1f", *nanoseconds);
  return text;
}

} // namespace

void printHead() {
  std::printf("%10s %6s %9s %9s %7s %7s %8s %8s %7s %6s %6s %6s  %s\n", "situation", "ratio", "ns a ray",
              "expected", "peer", "moved", "lookups", "expected", "exact", "alloc", "faults", "wrong",
              "what");
}

void printFinding(const Finding &finding) {
  const auto count = static_cast<double>(finding.situation.count);
  std::printf("%10llu %6.2f %9.1f %9.1f %7s %7s %8.1f %8.1f %7.2f %6llu %6llu %6llu  %s: %s, %s\n",
              static_cast<unsigned long long>(finding.situation.number), finding.ratio(),
              finding.rayNanoseconds(), finding.expected.nanoseconds / count, toString(finding.peer).c_str(),
              toString(finding.movedOff).c_str(), finding.lookups, finding.expected.lookups,
              finding.exactSteps, static_cast<unsigned long long>(finding.cost.allocations),
              static_cast<unsigned long long>(finding.cost.faults),
              static_cast<unsigned long long>(finding.wrong), finding.machine.c_str(),
              describe(finding.situation).c_str(), describe(finding.place).c_str());
}

void printReport(const std::vector<Finding> &findings, std::size_t worst) {
  std::vector<Finding> sorted = findings;
  std::ranges::sort(sorted, [](const Finding &a, const Finding &b) { return a.ratio() > b.ratio(); });
  sorted.resize(std::min(sorted.size(), worst));
  std::printf("\nthe worst of %zu\n", findings.size());
  printHead();
  for (const Finding &finding : sorted)
    printFinding(finding);
  printKinds(findings);
}

} // namespace voxc::cliffs
