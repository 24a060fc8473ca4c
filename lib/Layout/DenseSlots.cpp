// Dense slots: one for each child, x fastest, then y, then z. An empty one may tell its distance, in a word
// beside it or in its own. In ranked strata a slot ends with how many voxels come before those of its cell.
#include "Places.h"

#include "voxc/Layout/Layout.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {

void fitReach(Stratum &stratum) {
  auto *const distances = std::get_if<Distances>(&stratum.encoding);
  if (!distances)
    return;
  if (distances->metric == Metric::Octant)
    distances->reach = std::min(distances->reach, (1u << stratum.fieldBits()) - 1);
  if (distances->place == DistancePlace::Beside)
    return;
  // No cell is farther from another; so a reach that no distance comes up to says no more than this one.
  const Int3 size = stratum.log2Size();
  const auto cells = [](int log2) { return 1u << std::min(log2, kMaxLog2Extent); };
  const std::uint32_t farthest = cells(size.x) + cells(size.y) + cells(size.z);
  distances->reach = std::min(distances->reach, farthest);
}

namespace {

std::string problem(const Stratum &stratum) {
  const Distances *const distances = stratum.distances();
  if (!distances)
    return {};
  if (distances->reach == 0)
    return "distances have a reach of 1 at least";
  const std::uint64_t most = distances->metric == Metric::Octant     ? 1u << stratum.fieldBits()
                             : stratum.empty() == Empty::Tagged      ? std::uint64_t{1} << 31
                             : stratum.empty() == Empty::Transparent ? std::uint64_t{1} << 24
                                                                     : std::uint64_t{1} << 32;
  if (distances->reach >= most)
    return "a reach of " + std::to_string(distances->reach) + " does not fit into " +
           std::to_string(std::bit_width(most) - 1) + " bits, which " +
           (distances->metric == Metric::Octant ? "an octant has" : "an empty slot has");
  return {};
}

std::uint64_t slotOf(const Stratum &stratum, std::uint64_t node, Int3 place) {
  return node + static_cast<std::uint64_t>(stratum.slotWords()) * gridIndex(stratum.log2Shape, place);
}

std::uint64_t leastWords(const Stratum &stratum) {
  // Shapes that nobody checked may have 2^63 children.
  return static_cast<std::uint64_t>(stratum.slotWords()) << std::min(stratum.log2Children(), 62);
}

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t, std::uint64_t) { return leastWords(stratum); }

std::uint64_t size(const WordReader &, const Stratum &stratum, std::uint64_t) { return leastWords(stratum); }

/// What a slot says of how far a ray may skip; 0 where the cell is not empty.
std::uint32_t skipWord(const WordReader &words, const Stratum &stratum, std::uint64_t slot) {
  if (stratum.empty() == Empty::Zero)
    return stratum.distances() ? words[slot + 1] : 0;
  return stratum.isEmptySlot(words[slot]) ? words[slot] : 0;
}

void checkDistance(WordReader &words, const Stratum &stratum, std::uint64_t slot) {
  const bool empty = stratum.isEmptySlot(words[slot]);
  const std::uint32_t distance = distanceInSlot(skipWord(words, stratum, slot));
  if (!empty && distance != 0)
    words.fail("a cell of a distance field is not empty but has a distance");
  else if (empty && (distance == 0 || distance > stratum.distances()->reach))
    words.fail("an empty cell of a distance field has a distance outside 1.." +
               std::to_string(stratum.distances()->reach));
}

void checkOctants(WordReader &words, const Stratum &stratum, std::uint64_t slot) {
  const std::uint32_t fields = skipWord(words, stratum, slot);
  if (!stratum.isEmptySlot(words[slot])) {
    if (fields != 0)
      words.fail("a cell of a distance field is not empty but has empty cubes");
    return;
  }
  for (int octant = 0; octant < 8; ++octant) {
    const std::uint32_t side = fields >> octant * stratum.fieldBits() & ((1u << stratum.fieldBits()) - 1);
    if (side == 0 || side > stratum.distances()->reach)
      return words.fail("an empty cell of a distance field has an empty cube outside 1.." +
                        std::to_string(stratum.distances()->reach));
  }
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool) {
  const std::uint64_t count = size(words, stratum, node);
  if (!words.require(node, count, "a grid"))
    return false;
  if (!stratum.distances())
    return true;
  for (std::uint64_t slot = node; slot < node + count && !words.problem();
       slot += static_cast<std::uint64_t>(stratum.slotWords())) {
    if (stratum.measures(Metric::L1))
      checkDistance(words, stratum, slot);
    else
      checkOctants(words, stratum, slot);
  }
  return !words.problem();
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const std::uint64_t slot = slotOf(stratum, node, place);
  if (stratum.isEmptySlot(words[slot]))
    return {};
  Child child = {true, true, slot};
  if (stratum.ranked)
    child.before = words[slot + static_cast<std::uint64_t>(stratum.slotWords()) - 1];
  return child;
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  forEachPlace(stratum, [&](Int3 place) {
    if (const Child found = child(words, stratum, node, place); found.exists)
      visit(place, found);
  });
}

std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  if (!check(words, stratum, node, layer == 1))
    return 0;
  std::uint64_t count = 0;
  const std::uint64_t end = node + leastWords(stratum);
  for (std::uint64_t slot = node; slot < end; slot += static_cast<std::uint64_t>(stratum.slotWords())) {
    if (stratum.isEmptySlot(words[slot]))
      continue;
    if (stratum.cellValue(words[slot]) == 0)
      return 0;
    ++count;
  }
  return count;
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
              Relocation relocation) {
  for (std::size_t i = 0; i < words.size() && !holdsVoxels;
       i += static_cast<std::size_t>(stratum.slotWords())) {
    if (stratum.isEmptySlot(words[i]))
      continue;
    std::uint32_t ref = stratum.cellValue(words[i]);
    if (!relocateRef(ref, relocation))
      return false;
    words[i] = ref << stratum.tagShift();
  }
  return true;
}

EmptyRegion region(const Stratum &stratum) {
  return !stratum.distances()           ? EmptyRegion::Cell
         : stratum.measures(Metric::L1) ? EmptyRegion::Ball
                                        : EmptyRegion::Cube;
}

bool isDistanceBeside(const Stratum &stratum) {
  return stratum.distances() && stratum.distances()->place == DistancePlace::Beside;
}

double wordsRead(const Stratum &stratum, int, bool isEmpty) {
  return isEmpty && isDistanceBeside(stratum) ? 2 : 1;
}

std::uint64_t line(const Stratum &stratum, std::uint64_t cell) {
  constexpr int kLog2LineWords = 4;
  return cell >> (kLog2LineWords - (isDistanceBeside(stratum) ? 1 : 0));
}

std::optional<std::uint64_t> noSlotLine(const Stratum &, std::uint64_t) { return std::nullopt; }

RuntimeClass measuring(const Stratum &stratum) {
  if (!stratum.distances())
    return {};
  return stratum.measures(Metric::L1) ? RuntimeClass{"voxc_l1.h", "L1Field"}
                                      : RuntimeClass{"voxc_octant_cubes.h", "OctantField"};
}
RuntimeClass mending(const Stratum &stratum) {
  if (!stratum.distances())
    return {};
  return stratum.measures(Metric::L1) ? RuntimeClass{"voxc_l1_mending.h", "L1Mending"}
                                      : RuntimeClass{"voxc_octant_mending.h", "OctantMending"};
}

constexpr std::array<std::string_view, 2> kCells = {"dense", "cell"};
constexpr std::array<std::string_view, 2> kDistances = {"dense", "distances"};
std::span<const std::string_view> accessor(const Stratum &stratum) {
  return stratum.distances() ? kDistances : kCells;
}

} // namespace

extern const SlotKind kDenseSlots = {.name = "dense",
                                     .summary = "a slot for each child",
                                     .accessor = accessor,
                                     .construct = {"voxc_dense.h", "DenseGrid"},
                                     .measuring = measuring,
                                     .mending = mending,
                                     .edit = {"voxc_edited_dense.h", "EditedDense"},
                                     .encodings = encodingBits<std::monostate, Distances>,
                                     .hasEmptySlots = true,
                                     .ranks = true,
                                     .region = region,
                                     .cost = {wordsRead, line, noSlotLine},
                                     .problem = problem,
                                     .check = check,
                                     .leastWords = leastWords,
                                     .wordsWith = wordsWith,
                                     .size = size,
                                     .count = count,
                                     .child = child,
                                     .visit = visit,
                                     .relocate = relocate};

} // namespace voxc
