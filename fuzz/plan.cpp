// Fuzzes the text of plans: what is valid must come back from its own text.
#include "FuzzedFile.h"

#include "voxc/Plan/Plan.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  voxc::Diagnostics diagnostics;
  const voxc::Plan plan = voxc::parsePlan(voxc::fuzz::textOf(data, size), diagnostics);
  if (diagnostics.hasErrors())
    return 0;
  const std::string text = voxc::printPlan(plan);
  voxc::Diagnostics none;
  const voxc::Plan again = voxc::parsePlan(text, none);
  if (none.hasErrors() || again != plan || voxc::printPlan(again) != text)
    std::abort();
  return 0;
}
