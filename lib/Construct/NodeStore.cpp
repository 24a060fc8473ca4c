// Appending, sharing and counting.
#include "NodeStore.h"

#include <cstring>
#include <string>
#include <utility>

namespace voxc {
namespace {

constexpr std::uint64_t kInternsBetweenRelief = 8;
/// Grids larger than this go back to the system when they are done.
constexpr std::uint64_t kKeptGridBytes = std::uint64_t{1} << 20;

} // namespace

NodeStore::NodeStore(WordStore words, const Layout &layout, std::shared_ptr<WorkingMemory> memory)
    : memory_(std::move(memory)), words_(std::move(words)), array_(memory_),
      shared_(layout.strata.size() + 1) {
  levels_.reserve(layout.strata.size());
  for (std::size_t i = 0; i < layout.strata.size(); ++i) {
    levels_.emplace_back(memory_);
    if (layout.isIndexed(i)) {
      indexedLevel_ = static_cast<unsigned>(i + 1);
      indexBits_ = layout.strata[i - 1].indexBits;
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
  if (number >> indexBits_ != 0) {
    fail(Error::input("level " + std::to_string(level) + " has more than " + std::to_string(number - 1) +
                      " different sub-volumes, the most that pointers=" + std::to_string(indexBits_) +
                      " can tell; more bits, or a build without short-pointers, would fit"));
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

std::uint32_t NodeStore::append(unsigned level, std::span<const std::uint32_t> words) {
  if (failure_)
    return 1;
  const std::uint64_t offset = words_.size();
  if (offset + words.size() > maxWords_) {
    const std::string most = maxWords_ == kMaxWords
                                 ? "2^32 words (16 GiB), the most that offsets can reach: "
                                 : std::to_string(maxWords_) + " words, the most that it may have: ";
    fail(Error::input("the volume needs more than " + most + std::to_string(offset) +
                      " are written, and level " + std::to_string(level) +
                      " adds more; a lower resolution or a format that shares more would fit"));
    return 1;
  }
  std::uint64_t place = offset;
  if (level == indexedLevel_) {
    place = appendToArray(level, words);
    if (failure_)
      return 1;
  } else if (auto appended = words_.append(words); !appended) {
    fail(appended.error());
    return 1;
  }
  ++at(level).report.uniqueNodes;
  at(level).report.words += words.size();
  note(BlockRecord::Append, level, words.size());
  return static_cast<std::uint32_t>(place);
}

void NodeStore::relieve() {
  if (++interned_ % kInternsBetweenRelief == 0)
    memory_->relieve();
}

std::uint32_t NodeStore::found(unsigned level, std::uint32_t offset) {
  ++shared_[level];
  return offset;
}

std::uint32_t NodeStore::remember(BlockRecord::Kind kind, NodeMap &map, std::uint32_t hash, unsigned level,
                                  std::span<const std::uint32_t> words) {
  const std::uint32_t offset = append(level, words);
  if (failure_)
    return 1;
  if (log_)
    log_->back().kind = kind;
  const auto wordOf = [&](std::uint32_t at) {
    return level == indexedLevel_ ? at * static_cast<std::uint32_t>(kIndexedWords) : at;
  };
  if (auto inserted = map.insert(hash, wordOf(offset)); !inserted)
    fail(inserted.error());
  return offset;
}

std::uint32_t NodeStore::intern(unsigned level, std::span<const std::uint32_t> words) {
  if (failure_)
    return 1;
  relieve();
  NodeMap &map = at(level).nodes;
  const std::uint32_t hash = NodeMap::hashOf(words);
  const bool isIndexed = level == indexedLevel_;
  if (const auto known =
          map.find(hash, words, isIndexed ? std::span(std::as_const(array_).span()) : words_.span()))
    return found(level, isIndexed ? *known / static_cast<std::uint32_t>(kIndexedWords) : *known);
  return remember(BlockRecord::Intern, map, hash, level, words);
}

std::uint32_t NodeStore::internLeaf(unsigned level, std::uint32_t value) {
  if (failure_)
    return 1;
  relieve();
  NodeMap &map = at(level).leaves;
  const std::uint32_t hash = NodeMap::hashOf(value);
  if (const auto known = map.find(hash))
    return found(level, *known);
  return remember(BlockRecord::InternLeaf, map, hash, level, {&value, 1});
}

void NodeStore::forget(unsigned level) {
  at(level).leaves.clear();
  at(level).nodes.clear();
  note(BlockRecord::Forget, level, 0);
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
  shared_.assign(shared_.size(), 0);
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
    reports.back().sharedNodes = shared_[i + 1];
  }
  return reports;
}

} // namespace voxc
