// What the values of a scene's voxels ask of a format.
#include "voxc/Search/SceneValues.h"

#include "Construct/ValueStore.h"

namespace voxc {

/// A build's, of a layout without levels.
struct SceneValues::Stores {
  Stores(WordStore words, VoxelFacts facts, const std::shared_ptr<WorkingMemory> &memory)
      : nodes(std::move(words), Layout{}, memory), values(nodes, facts, memory) {}

  NodeStore nodes;
  ValueStore values;
};

SceneValues::SceneValues(std::unique_ptr<Stores> stores) : stores_(std::move(stores)) {}
SceneValues::~SceneValues() = default;
SceneValues::SceneValues(SceneValues &&) noexcept = default;
SceneValues &SceneValues::operator=(SceneValues &&) noexcept = default;

Expected<SceneValues> SceneValues::create(const std::shared_ptr<WorkingMemory> &memory, VoxelFacts facts) {
  auto words = WordStore::create(memory);
  if (!words)
    return words.error();
  return SceneValues(std::make_unique<Stores>(std::move(*words), facts, memory));
}

void SceneValues::add(std::span<const std::uint32_t> cells) {
  for (const std::uint32_t &cell : cells) {
    if (cell == 0)
      continue;
    if (!first_)
      first_ = cell;
    isOne_ &= cell == *first_;
    isVisible_ &= cell >> 24 != 0;
    ++voxels_;
    stores_->values.put({&cell, 1});
  }
}

Expected<std::uint64_t> SceneValues::finish() {
  WordStore &words = stores_->nodes.words();
  const std::uint64_t before = words.size();
  stores_->values.finish(words, kMaxWords);
  if (stores_->nodes.failure())
    return *stores_->nodes.failure();
  return words.size() - before;
}

} // namespace voxc
