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

NodeStore::NodeStore(WordStore words, std::size_t levels, std::shared_ptr<WorkingMemory> memory)
    : memory_(std::move(memory)), words_(std::move(words)) {
  levels_.reserve(levels);
  for (std::size_t i = 0; i < levels; ++i)
    levels_.emplace_back(memory_);
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
  if (auto appended = words_.append(words); !appended) {
    fail(appended.error());
    return 1;
  }
  ++at(level).report.uniqueNodes;
  at(level).report.words += words.size();
  note(BlockRecord::Append, level, words.size());
  return static_cast<std::uint32_t>(offset);
}

std::uint32_t NodeStore::intern(unsigned level, std::span<const std::uint32_t> words) {
  if (failure_)
    return 1;
  Level &store = at(level);
  const bool isLeaf = words.size() == 1;
  NodeMap &map = isLeaf ? store.leaves : store.nodes;
  const std::uint32_t hash = isLeaf ? NodeMap::hashOf(words[0]) : NodeMap::hashOf(words);
  if (++interned_ % kInternsBetweenRelief == 0)
    memory_->relieve();
  if (const auto known = isLeaf ? map.find(hash) : map.find(hash, words, words_.span())) {
    ++store.report.sharedNodes;
    return *known;
  }
  const std::uint32_t offset = append(level, words);
  if (failure_)
    return 1;
  if (log_)
    log_->back().kind = BlockRecord::Intern;
  if (auto inserted = map.insert(hash, offset); !inserted)
    fail(inserted.error());
  return offset;
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
  if (!store.grid.data()) {
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

void NodeStore::clear() {
  words_.clear();
  for (Level &level : levels_) {
    level.leaves.clear();
    level.nodes.clear();
  }
}

std::vector<LevelReport> NodeStore::report() const {
  std::vector<LevelReport> reports;
  reports.reserve(levels_.size());
  for (const Level &level : levels_)
    reports.push_back(level.report);
  return reports;
}

} // namespace voxc
