// How a kernel reaches words.
#include "MemoryNames.h"

#include "voxc/Layout/SlotKind.h"

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

/// One axis of a cell's number, `bits` of them from bit `at` on: those from bit `from` on, or those before
/// it.
std::string upperBits(const std::string &axis, int bits, int at, int from) {
  if (bits == 0)
    return "";
  if (at >= from)
    return at == from ? axis : axis + " << " + std::to_string(at - from);
  return at + bits > from ? axis + " >> " + std::to_string(from - at) : "";
}

std::string lowerBits(const std::string &axis, int bits, int at, int from) {
  if (bits == 0 || at >= from)
    return "";
  const int kept = from - at;
  const std::string value = bits <= kept ? axis : "(" + axis + " & " + std::to_string((1 << kept) - 1) + ")";
  return at == 0 ? value : value + " << " + std::to_string(at);
}

/// The number of a cell, as bits of its place, in two parts: 2^log2Granule cells are one.
std::string cellNumber(Int3 log2Size, int log2Granule,
                       std::string (*part)(const std::string &, int, int, int)) {
  std::string text;
  int at = 0;
  for (const int axis : {0, 1, 2}) {
    const std::string bits = part(std::string("at.") + "xyz"[axis], log2Size[axis], at, log2Granule);
    text += (text.empty() || bits.empty() ? "" : " | ") + bits;
    at += log2Size[axis];
  }
  return text.empty() ? "0" : text;
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
  const bool shared = plan.sharesStack();
  names.conditions["stack-shared"] = shared;
  names.holes["of-ray"] = shared ? "[gl_LocalInvocationIndex]" : "";
}

} // namespace

void addMemoryNames(TemplateNames &names, const Plan &plan) {
  addAddresses(names, plan);
  addPaging(names, plan);
  addStack(names, plan);
}

void addReferenceNames(TemplateNames &names, const Layout &layout, const Stratum &stratum) {
  const std::uint64_t recordGranules = stratum.slots->leastWords(stratum) >> layout.log2Granule;
  names.holes["records-times"] = recordGranules == 1 ? "" : std::to_string(recordGranules) + "u * ";
  names.holes["granule-of-cell"] = cellNumber(stratum.log2Size(), layout.log2Granule, upperBits);
  names.holes["cell-in-granule"] = cellNumber(stratum.log2Size(), layout.log2Granule, lowerBits);
}

} // namespace voxc
