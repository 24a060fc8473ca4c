// Reading and comparing cases.
#include "Cases.h"

#include <sstream>

namespace voxc::cliffs {
namespace {

constexpr double kMargin = 1.02;
constexpr double kRounding = 0.002;
/// Allocations that depend on the library that is underneath, as of threads.
constexpr std::uint64_t kSomeAllocations = 8;

std::string more(const char *what, double now, double then) {
  if (now <= kMargin * then + kRounding)
    return "";
  return std::string(what) + " a ray are " + std::to_string(now) + ", and were " + std::to_string(then);
}

} // namespace

Expected<std::vector<KeptCase>> parseCases(std::string_view text, const std::string &name) {
  std::vector<KeptCase> cases;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#')
      continue;
    KeptCase kept;
    std::istringstream fields(line);
    if (!(fields >> kept.number >> kept.machine >> kept.lookups >> kept.exactSteps >> kept.allocations) ||
        fields.get() != '\t' || !std::getline(fields, kept.what))
      return Error::input(name + ":" + std::to_string(number) +
                          ": a case is a number, a device, three counts, a place and rays");
    cases.push_back(std::move(kept));
  }
  return cases;
}

std::string worsened(const KeptCase &kept, const Finding &finding) {
  if (const std::string what = describe(finding.place) + "\t" + describe(finding.situation);
      what != kept.what)
    return "it is '" + what + "' now, and was '" + kept.what + "'";
  if (const std::string text = more("look-ups", finding.lookups, kept.lookups); !text.empty())
    return text;
  if (const std::string text = more("exact steps", finding.exactSteps, kept.exactSteps); !text.empty())
    return text;
  if (finding.cost.allocations > kept.allocations + kSomeAllocations)
    return "allocations of a call are " + std::to_string(finding.cost.allocations) + ", and were " +
           std::to_string(kept.allocations);
  return "";
}

} // namespace voxc::cliffs
