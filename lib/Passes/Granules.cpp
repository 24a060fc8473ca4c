// granules: references that count granules of twice as many words.
//
// Contract: sets granule=2, or doubles it. Volumes have the same voxels. What cannot count so is an error,
// and the format stays as it is.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult granules(Format &format, Diagnostics &diagnostics) {
  const auto values = kGranuleAttribute.values;
  const auto next = static_cast<std::size_t>(format.attributes.get(kGranuleAttribute)) + 1;
  if (next == values.size()) {
    diagnostics.note({}, "granule=" + std::string(values.back()) + " is the largest");
    return PassResult::Unchanged;
  }
  Format wider = format;
  wider.setAttribute(kGranuleAttribute, values[next]);
  Diagnostics problems;
  verify(wider, problems);
  for (const Diagnostic &problem : problems.all())
    diagnostics.error(problem.range, problem.message);
  if (problems.hasErrors())
    return PassResult::Unchanged;
  format = std::move(wider);
  return PassResult::Changed;
}

} // namespace voxc
