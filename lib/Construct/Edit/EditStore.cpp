// Changing grids in place or in a copy, and which words that changed.
#include "EditStore.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace voxc {
namespace {

/// Differing words that are no farther apart are one run: each run is a copy of its own to a device.
constexpr std::uint64_t kJoinedWords = 64;

} // namespace

Expected<std::unique_ptr<EditStore>> EditStore::create(std::span<const std::uint32_t> words,
                                                       const Layout &layout,
                                                       const std::shared_ptr<WorkingMemory> &memory) {
  auto store = VOXC_TRY(WordStore::createShared(memory, layout.maxWords()));
  VOXC_TRY(store.append(words.subspan(1)));
  store.setRoot(words[0]);
  std::unique_ptr<EditStore> result(new EditStore(std::move(store), layout, memory));
  result->known_ = words.size();
  return result;
}

std::uint32_t *EditStore::open(unsigned level, Ref old, std::uint64_t count) {
  OpenGrid &grid = open_[level - 1];
  const std::uint64_t at = layout_.reader(words()).wordOf(old);
  const bool isAlone = level == 1 && layout_.strata[0].sharing != Sharing::Level;
  grid = {nullptr, count, old, isAlone && old != 0 && at >= sealed_};
  if (grid.inPlace)
    return grid.words = nodes_.words().at(at);
  grid.words = nodes_.allocate(level, count);
  if (grid.words && old != 0)
    std::memcpy(grid.words, nodes_.words().at(at), count * sizeof(std::uint32_t));
  return grid.words;
}

void EditStore::touch(unsigned level, const std::uint32_t *words, std::uint64_t count) {
  if (!open_[level - 1].inPlace)
    return;
  const auto at = static_cast<std::uint64_t>(words - nodes_.words().at(0));
  saved_.push_back({at, {words, words + count}});
}

Ref EditStore::close(unsigned level, bool shared) {
  const OpenGrid grid = open_[level - 1];
  if (grid.inPlace)
    return grid.old;
  const std::span<const std::uint32_t> words(grid.words, grid.count);
  const Ref place = shared ? nodes_.intern(level, words) : nodes_.append(level, words);
  nodes_.release(level);
  return place;
}

void EditStore::abandon(unsigned level) {
  if (!open_[level - 1].inPlace)
    nodes_.release(level);
}

/// Notes runs of words that are others than they were.
void EditStore::noteDifferences(const Saved &saved) {
  const std::uint32_t *const now = nodes_.words().at(saved.at);
  for (std::uint64_t i = 0; i < saved.words.size(); ++i) {
    if (now[i] == saved.words[i])
      continue;
    const std::uint64_t at = saved.at + i;
    if (!changed_.empty() && changed_.back().first <= at && at <= changed_.back().end + kJoinedWords)
      changed_.back().end = std::max(changed_.back().end, at + 1);
    else
      changed_.push_back({at, at + 1});
  }
}

void EditStore::commit(Ref root) {
  for (const Saved &saved : saved_)
    noteDifferences(saved);
  saved_.clear();
  setHead(root, 0);
}

void EditStore::rollBack() {
  for (; !saved_.empty(); saved_.pop_back())
    std::ranges::copy(saved_.back().words, nodes_.words().at(saved_.back().at));
}

void EditStore::setHead(Ref root, std::uint32_t colour) {
  if (root != this->root())
    changed_.push_back({0, 1});
  nodes_.words().setRoot(root);
  if (colour != 0 && words()[1] != colour) {
    nodes_.words().setHead(1, colour);
    changed_.push_back({1, 2});
  }
}

Expected<MemoryBlock> EditStore::view(Ref root) const {
  auto view = nodes_.words().view();
  if (view)
    *reinterpret_cast<std::uint32_t *>(view->data()) = root;
  return view;
}

std::vector<WordRange> EditStore::takeChanges() {
  std::vector<WordRange> changes = std::exchange(changed_, {});
  if (root() == 0) { // What is not of the head is of the volume when it has voxels again.
    const auto isOfHead = [this](const WordRange &range) { return range.first < layout_.headWords(); };
    std::ranges::remove_copy_if(changes, std::back_inserter(changed_), isOfHead);
    std::erase_if(changes, [&](const WordRange &range) { return !isOfHead(range); });
    return changes;
  }
  if (words().size() > known_)
    changes.push_back({known_, words().size()});
  known_ = words().size();
  std::ranges::sort(changes, {}, &WordRange::first);
  std::vector<WordRange> joined;
  for (const WordRange &range : changes)
    if (!joined.empty() && range.first <= joined.back().end + kJoinedWords)
      joined.back().end = std::max(joined.back().end, range.end);
    else
      joined.push_back(range);
  return joined;
}

/// A run may begin in the head and end behind it, which a volume without voxels lacks.
void EditStore::putBackChanges(std::span<const WordRange> changes) {
  const std::uint64_t head = layout_.headWords();
  for (const WordRange &range : changes) {
    if (range.first < head)
      changed_.push_back({range.first, std::min(range.end, head)});
    if (range.end > head)
      changed_.push_back({std::max(range.first, head), range.end});
  }
}

} // namespace voxc
