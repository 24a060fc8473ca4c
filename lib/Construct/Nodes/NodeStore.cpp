// Appending, sharing and counting.
#include "NodeStore.h"

#include "voxc/Layout/SlotKind.h"

#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

namespace voxc {
namespace {

constexpr std::uint64_t kInternsBetweenRelief = 8;
/// Grids larger than this go back to the system when they are done.
constexpr std::uint64_t kKeptGridBytes = std::uint64_t{1} << 20;

/// The bytes of so many words, a power of two of them.
std::string sizeText(std::uint64_t words) {
  const std::uint64_t mebibytes = words >> 18;
  return mebibytes % 1024 == 0 ? std::to_string(mebibytes / 1024) + " GiB"
                               : std::to_string(mebibytes) + " MiB";
}

} // namespace

NodeStore::NodeStore(WordStore words, const Layout &layout, std::shared_ptr<WorkingMemory> memory)
    : layout_(layout), memory_(std::move(memory)), words_(std::move(words)), maxWords_(layout.maxWords()),
      array_(memory_) {
  levels_.reserve(layout.strata.size());
  for (std::size_t i = 0; i < layout.strata.size(); ++i) {
    const Stratum &stratum = layout.strata[i];
    levels_.emplace_back(memory_, layout.log2UnitOf(i));
    if (stratum.inArray()) {
      indexedLevel_ = static_cast<unsigned>(i + 1);
      numberBits_ = stratum.numberBits;
      beginArray();
    }
  }
}

/// Number 0 is none.
void NodeStore::beginArray() {
  if (auto begun = array_.resize(kIndexedWords); !begun)
    fail(begun.error());
}

std::uint32_t NodeStore::appendToArray(unsigned level, std::span<const std::uint32_t> words) {
  const std::uint64_t number = array_.size() / kIndexedWords;
  if (number >> numberBits_ != 0) {
    fail(Error::input("level " + std::to_string(level) + " has more than " + std::to_string(number - 1) +
                      " different sub-volumes, the most that pointers=" + std::to_string(numberBits_) +
                      " can number; more bits, or a build without short-pointers, would fit"));
    return 1;
  }
  if (auto appended = array_.append(words); !appended) {
    fail(appended.error());
    return 1;
  }
  return static_cast<std::uint32_t>(number);
}

void NodeStore::fail(Error error) {
  if (!failure_)
    failure_ = std::move(error);
}

void NodeStore::note(BlockRecord::Kind kind, unsigned level, std::uint64_t words) {
  if (log_)
    log_->push_back({kind, level, words});
}

Error NodeStore::tooManyWords(unsigned level) const {
  const bool isGiven = maxWords_ < layout_.maxWords();
  const std::string most = isGiven ? std::to_string(maxWords_) + " words, the most that it may have: "
                                   : "2^" + std::to_string(std::bit_width(maxWords_) - 1) + " words (" +
                                         sizeText(maxWords_) + "), the most that references can reach: ";
  return Error::input("the volume needs more than " + most + std::to_string(words_.size()) +
                      " are written, and level " + std::to_string(level) + " adds more; " +
                      (isGiven ? "" : adviceOfReach(layout_)) +
                      "a lower resolution or a format that shares more would fit");
}

/// Fails where a node of so many words would not fit into a volume, or could not be reached.
bool NodeStore::fits(unsigned level, std::uint64_t words) {
  if (layout_.granuleAfter(words_.size()) + words > maxWords_)
    fail(tooManyWords(level));
  else if (words > layout_.maxNodeWords() && !layout_.strata[level - 1].slots->hasEmptySlots)
    fail(Error::input("level " + std::to_string(level) + " has a sub-volume of " + std::to_string(words) +
                      " words, more than the 2^32 - 2^28 that a kernel can reach in one where references "
                      "count granules; two levels in its place would fit"));
  return !failure_;
}

void NodeStore::align() {
  static constexpr std::array<std::uint32_t, std::size_t{1} << kMaxLog2Granule> kZeros{};
  const std::uint64_t missing = layout_.granuleAfter(words_.size()) - words_.size();
  if (missing == 0)
    return;
  if (auto appended = words_.append(std::span(kZeros).first(missing)); !appended)
    fail(appended.error());
}

Ref NodeStore::append(unsigned level, std::span<const std::uint32_t> words) {
  const Ref place = put(level, words);
  if (references_ && !failure_ && level != indexedLevel_)
    references_->addNode(level - 1, layout_.reader(words_.span()), words_.size() - words.size(),
                         words.size());
  return place;
}

/// The block of a node or a leaf.
Ref NodeStore::put(unsigned level, std::span<const std::uint32_t> words) {
  if (failure_ || !fits(level, words.size()))
    return 1;
  const std::uint64_t before = words_.size();
  Ref place = 0;
  if (level == indexedLevel_) {
    place = appendToArray(level, words);
  } else {
    align();
    place = layout_.refOf(words_.size());
    if (auto appended = words_.append(words); !appended)
      fail(appended.error());
  }
  if (failure_)
    return 1;
  ++at(level).report.uniqueNodes;
  at(level).report.words += level == indexedLevel_ ? words.size() : words_.size() - before;
  note(BlockRecord::Append, level, words.size());
  return place;
}

void NodeStore::relieve() {
  if (++interned_ % kInternsBetweenRelief == 0)
    memory_->relieve();
}

Ref NodeStore::remember(BlockRecord::Kind kind, NodeMap &map, std::uint32_t hash, unsigned level,
                        std::span<const std::uint32_t> words) {
  const bool isLeaf = kind == BlockRecord::InternLeaf;
  const Ref place = isLeaf ? put(level, words) : append(level, words);
  if (failure_)
    return 1;
  if (isLeaf && references_)
    references_->addLeaf(level - 1);
  if (log_)
    log_->back().kind = kind;
  if (auto inserted = map.insert(hash, place); !inserted)
    fail(inserted.error());
  return place;
}

Ref NodeStore::intern(unsigned level, std::span<const std::uint32_t> words, std::uint32_t hash) {
  if (failure_)
    return 1;
  relieve();
  NodeMap &map = at(level).nodes;
  if (const auto known = map.find(hash, words, written(level)))
    return *known;
  return remember(BlockRecord::Intern, map, hash, level, words);
}

std::optional<Ref> NodeStore::knownLeaf(unsigned level, std::uint32_t value) {
  if (failure_)
    return Ref{1};
  return at(level).leaves.find(NodeMap::hashOf(value));
}

Ref NodeStore::internLeaf(unsigned level, std::uint32_t value) {
  if (const auto known = knownLeaf(level, value))
    return *known;
  relieve();
  return remember(BlockRecord::InternLeaf, at(level).leaves, NodeMap::hashOf(value), level, {&value, 1});
}

void NodeStore::adopt(unsigned level, std::span<const std::uint32_t> words, Ref place) {
  if (auto inserted = at(level).nodes.insert(NodeMap::hashOf(words), place); !inserted)
    fail(inserted.error());
}

void NodeStore::adoptLeaf(unsigned level, std::uint32_t value, Ref place) {
  if (auto inserted = at(level).leaves.insert(NodeMap::hashOf(value), place); !inserted)
    fail(inserted.error());
}

std::uint32_t NodeStore::fetch(unsigned level, std::span<const std::uint32_t> words) {
  const std::uint32_t hash = NodeMap::hashOf(words);
  at(level).nodes.fetch(hash);
  return hash;
}

void NodeStore::fetchNode(unsigned level, std::uint32_t hash) {
  at(level).nodes.fetchNode(hash, written(level));
}

void NodeStore::announce(unsigned level, std::span<const std::uint32_t> words) {
  if (announcedCount_ < announced_.size())
    announced_[announcedCount_++] = fetch(level, words);
}

void NodeStore::endAnnouncing(unsigned level) {
  for (const std::uint32_t hash : std::span(announced_).first(announcedCount_))
    fetchNode(level, hash);
  announcedCount_ = 0;
}

void NodeStore::forget(unsigned level) {
  at(level).leaves.clear();
  at(level).nodes.clear();
  note(BlockRecord::Forget, level, 0);
}

void NodeStore::forgetAll() {
  for (Level &level : levels_) {
    level.leaves = NodeMap(memory_);
    level.nodes = NodeMap(memory_);
    level.kept = ScratchArray<KeptCell>(memory_);
    level.grid = {};
  }
}

std::uint32_t *NodeStore::allocate(unsigned level, std::uint64_t count) {
  if (failure_)
    return nullptr;
  Level &store = at(level);
  if (store.grid.size() < count * sizeof(std::uint32_t)) {
    auto block = memory_->allocate(count * sizeof(std::uint32_t));
    if (!block) {
      fail(block.error());
      return nullptr;
    }
    store.grid = std::move(*block);
  }
  store.gridWords = count;
  return reinterpret_cast<std::uint32_t *>(store.grid.data());
}

void NodeStore::release(unsigned level) {
  Level &store = at(level);
  const std::uint64_t bytes = std::exchange(store.gridWords, 0) * sizeof(std::uint32_t);
  if (bytes > kKeptGridBytes)
    store.grid = {};
  else
    std::memset(store.grid.data(), 0, bytes);
}

void NodeStore::keep(unsigned level, std::uint32_t cell, std::uint32_t value) {
  if (failure_)
    return;
  if (auto pushed = at(level).kept.push({cell, value}); !pushed)
    fail(pushed.error());
}

void NodeStore::drop(unsigned level) {
  // Emptying an array costs what it holds; a large one goes back to the system.
  ScratchArray<KeptCell> &kept = at(level).kept;
  if (kept.size() * sizeof(KeptCell) > kKeptGridBytes)
    kept = ScratchArray<KeptCell>(memory_);
  else if (auto emptied = kept.resize(0); !emptied)
    fail(emptied.error());
}

void NodeStore::clear() {
  words_.clear();
  if (indexedLevel_ != 0)
    beginArray();
  for (Level &level : levels_) {
    level.leaves.clear();
    level.nodes.clear();
  }
}

std::vector<LevelReport> NodeStore::report() const {
  std::vector<LevelReport> reports;
  reports.reserve(levels_.size());
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    reports.push_back(levels_[i].report);
    if (references_)
      reports.back().sharedNodes = references_->sharedOf(i, reports.back().uniqueNodes);
  }
  return reports;
}

} // namespace voxc
