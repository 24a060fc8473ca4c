// Hashed slots: a table of the cells that are not empty, found by linear probing. [log2 of the entries,
// longest probe], then two words an entry: the cell's number, its value; an entry of value 0 is free.
#include "Places.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

namespace voxc {
namespace {

constexpr std::uint64_t kHeadWords = 2;
/// As in construct-runtime/voxc_hashed.h: tables grow until no probe is longer.
constexpr std::uint32_t kLongestProbe = 64;

std::string problem(const Stratum &stratum) {
  if (stratum.log2Children() > 32)
    return "a hashed grid has 2^32 cells at most, so that a cell's number is a word";
  return {};
}

/// One table, whose head was read.
struct Table {
  Table(const WordReader &words, std::uint64_t node)
      : words(words), entriesAt(node + kHeadWords), log2Entries(words[node] & 31), probes(words[node + 1]) {}

  std::uint64_t entries() const { return std::uint64_t{1} << log2Entries; }
  std::uint32_t key(std::uint64_t entry) const { return words[entriesAt + 2 * entry]; }
  std::uint64_t valueAt(std::uint64_t entry) const { return entriesAt + 2 * entry + 1; }
  bool isFree(std::uint64_t entry) const { return words[valueAt(entry)] == 0; }

  /// The entry of a cell, or that many entries as there are.
  std::uint64_t find(std::uint32_t cell) const {
    const std::uint32_t home = log2Entries == 0 ? 0 : cell * 0x9e3779b1u >> (32 - log2Entries);
    for (std::uint32_t i = 0; i < std::min(probes, kLongestProbe); ++i) {
      const std::uint64_t entry = (home + i) & (entries() - 1);
      if (isFree(entry))
        return entries();
      if (key(entry) == cell)
        return entry;
    }
    return entries();
  }

  const WordReader &words;
  std::uint64_t entriesAt;
  std::uint32_t log2Entries;
  std::uint32_t probes;
};

std::uint64_t leastWords(const Stratum &) { return kHeadWords + 4; }

/// Half of the entries are free at least.
std::uint64_t wordsWith(const Stratum &, std::uint64_t slots, std::uint64_t) {
  return kHeadWords + 2 * std::max<std::uint64_t>(std::bit_ceil(2 * slots), 2);
}

std::uint64_t size(const WordReader &words, const Stratum &, std::uint64_t node) {
  return kHeadWords + 2 * Table(words, node).entries();
}

/// Each entry is the one that its own cell finds, so none is there twice.
bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool) {
  if (!words.require(node, kHeadWords, "a hashed grid") ||
      !words.require(node, size(words, stratum, node), "a hashed grid"))
    return false;
  const Table table(words, node);
  const std::uint64_t cells = std::uint64_t{1} << stratum.log2Children();
  bool isRight = words[node] >= 1 && words[node] <= 31 && table.probes >= 1 && table.probes <= kLongestProbe;
  std::uint64_t used = 0;
  for (std::uint64_t entry = 0; entry < table.entries() && isRight; ++entry) {
    used += table.isFree(entry) ? 0 : 1;
    isRight = table.isFree(entry) ? table.key(entry) == 0
                                  : table.key(entry) < cells && table.find(table.key(entry)) == entry;
  }
  if (!isRight || used == 0)
    words.fail("a hashed grid has entries that no probe finds, or none");
  return !words.problem();
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const Table table(words, node);
  const std::uint64_t entry = table.find(static_cast<std::uint32_t>(gridIndex(stratum.log2Shape, place)));
  return entry == table.entries() ? Child{} : Child{true, true, table.valueAt(entry)};
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const Table table(words, node);
  const Int3 shape = stratum.log2Shape;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> found; // Position in Morton order, place of the value.
  for (std::uint64_t entry = 0; entry < table.entries(); ++entry) {
    if (table.isFree(entry))
      continue;
    const std::uint32_t cell = table.key(entry);
    const Int3 place = {static_cast<std::int32_t>(cell & ((1u << shape.x) - 1)),
                        static_cast<std::int32_t>(cell >> shape.x & ((1u << shape.y) - 1)),
                        static_cast<std::int32_t>(std::uint64_t{cell} >> (shape.x + shape.y))};
    found.emplace_back(mortonCode(place), table.valueAt(entry));
  }
  std::ranges::sort(found);
  for (const auto &[code, at] : found)
    visit(mortonCell(code), {true, true, at});
}

bool relocate(std::span<std::uint32_t> words, const Stratum &, bool holdsVoxels, Relocation relocation) {
  for (std::size_t value = kHeadWords + 1; value < words.size() && !holdsVoxels; value += 2)
    if (words[value] != 0 && !relocateRef(words[value], relocation))
      return false;
  return true;
}

/// The head and an entry: most probes find their cell, or a free entry, at once.
double wordsRead(const Stratum &, int, bool) { return 4; }
/// Anywhere.
std::uint64_t line(const Stratum &, std::uint64_t cell) { return cell; }
std::optional<std::uint64_t> noSlotLine(const Stratum &, std::uint64_t) { return std::nullopt; }

constexpr std::array<std::string_view, 1> kFiles = {"hashed"};
std::span<const std::string_view> files(const Stratum &) { return kFiles; }

} // namespace

extern const SlotKind kHashedSlots = {.name = "hashed",
                                      .summary = "a table of the cells that are not empty, found by probing",
                                      .accessor = files,
                                      .construct = {"voxc_hashed.h", "HashedGrid"},
                                      .edit = {"voxc_edited_hashed.h", "EditedHashed"},
                                      .lookUpLoops = true,
                                      .cost = {wordsRead, line, noSlotLine},
                                      .problem = problem,
                                      .check = check,
                                      .leastWords = leastWords,
                                      .wordsWith = wordsWith,
                                      .size = size,
                                      .child = child,
                                      .visit = visit,
                                      .relocate = relocate};

} // namespace voxc
