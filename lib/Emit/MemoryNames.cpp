// How a kernel reaches words.
#include "MemoryNames.h"

#include <string>

namespace voxc {
namespace {

/// Addresses. Where references count words, an offset is added to one; where they count granules, the two
/// stay apart, and `load_word` takes both. A hole that ends in a plus stands where an offset begins, and is
/// left out in the second case; one that ends in a comma stands before a whole offset, and is left out in the
/// first.
void addAddresses(TemplateNames &names, const Plan &plan) {
  const int log2Granule = plan.layout.log2Granule;
  const bool granules = log2Granule > 0;
  auto &holes = names.holes;
  holes["+"] = granules ? ", " : " + ";
  for (const std::string name : {"grid", "table", "node", "section"}) {
    holes[name + "+"] = granules ? "" : name + " + ";
    holes[name + ","] = granules ? name + ", " : "";
  }
  holes["uint-section,"] = granules ? "uint section, " : "";
  holes["section-begin"] = granules ? "section, 0u" : "section";
  holes["head,"] = granules ? "0u, " : "";
  holes["log2-granule"] = std::to_string(log2Granule);
  holes["granule-words"] = std::to_string(1 << log2Granule);
  names.conditions["granules"] = granules;
}

/// How words are reached, and what becomes of a ray that waits for some of them.
void addPaging(TemplateNames &names, const Plan &plan) {
  const bool paged = plan.addressing == Addressing::Paged;
  names.conditions["segments"] = plan.addressing == Addressing::Segments;
  names.conditions["paged"] = paged;
  names.holes["cut-short"] = paged ? "kernel.lacks_page ? DONE : LET_GO" : "LET_GO";
  names.holes["may-have-waited"] = paged ? "true" : "false";
  names.holes["waited-or"] = paged ? "waited || " : "";
}

/// Where a walk keeps nodes.
void addStack(TemplateNames &names, const Plan &plan) {
  const bool shared = plan.stack == Stack::Shared;
  names.conditions["stack-shared"] = shared;
  names.holes["of-ray"] = shared ? "[gl_LocalInvocationIndex]" : "";
}

} // namespace

void addMemoryNames(TemplateNames &names, const Plan &plan) {
  addAddresses(names, plan);
  addPaging(names, plan);
  addStack(names, plan);
}

} // namespace voxc
