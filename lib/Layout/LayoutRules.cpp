// How many words a sub-volume may take, where its nodes may begin, and how far references reach.
#include "LayoutRules.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

/// log2 of the most cells of a grid whose masks tell them, where references count granules: all its slots, of
/// two words each, and its mask are `kMaxNodeWords` at most.
constexpr int kMaxLog2MaskedCells = 30;

/// The same of granules of 2^log2Granule words.
std::string granuleProblem(const Stratum &stratum, int log2Granule) {
  if (log2Granule == 0)
    return {};
  const std::string granules = "granules of " + std::to_string(1 << log2Granule) + " words";
  if (stratum.hasRecords() && stratum.slots->leastWords(stratum) % (std::uint64_t{1} << log2Granule) != 0)
    return "its records, of " + std::to_string(stratum.slots->leastWords(stratum)) +
           " words each, stand side by side and would not begin at " + granules +
           "; granule=2, or svdag in place of svo, would do";
  if (!stratum.slots->countsWords.empty())
    return "references " + std::string(stratum.slots->countsWords) + ", and cannot count " + granules +
           "; leave out one of both";
  if (stratum.isGrid() && stratum.slots->hasChildMask && stratum.log2Children() > kMaxLog2MaskedCells)
    return "a masked grid has at most 2^" + std::to_string(kMaxLog2MaskedCells) +
           " cells where references count " + granules + "; two masked levels in its place would do";
  return {};
}

} // namespace

std::string granuleProblem(const Layout &layout, const Stratum &stratum) {
  return granuleProblem(stratum, std::clamp(layout.log2Granule, 0, kMaxLog2Granule));
}

std::string adviceOfReach(const Layout &layout) {
  const int log2 = layout.log2Granule + 1;
  const auto cannot = [&](const Stratum &stratum) { return !granuleProblem(stratum, log2).empty(); };
  if (log2 > kMaxLog2Granule || std::ranges::any_of(layout.strata, cannot))
    return {};
  return "granule=" + std::to_string(1 << log2) +
         (log2 == 1 ? " (the pass granules)" : " (granules once more)") + ", ";
}

std::string sizeProblem(const Layout &layout, const Stratum &stratum) {
  const std::uint64_t words = stratum.slots->leastWords(stratum);
  // So many words would leave none for the root's reference.
  const int log2Most = std::bit_width(kMaxWords) - 1 + layout.log2Granule;
  if (words >> log2Most == 0)
    return {};
  const Int3 size = stratum.log2Size();
  std::string text = "one sub-volume of 2^" + std::to_string(size.x) + " x 2^" + std::to_string(size.y) +
                     " x 2^" + std::to_string(size.z) + " cells takes 2^" +
                     std::to_string(std::bit_width(words) - 1) + " words; a volume holds fewer than 2^" +
                     std::to_string(log2Most);
  if (const int needed = std::bit_width(words) - std::bit_width(kMaxWords) + 1; needed <= kMaxLog2Granule)
    text += ", or more with granule=" + std::to_string(1 << needed) + " in IR text";
  const auto isPower = [](std::int32_t n) { return n > 1 && (n & (n - 1)) == 0; };
  if (isPower(size.x) && isPower(size.y) && isPower(size.z))
    text += " (sizes are log2: " + std::to_string(size.x) + " cells are written " +
            std::to_string(std::bit_width(static_cast<std::uint32_t>(size.x)) - 1) + ")";
  return text;
}

} // namespace voxc
