// What the values of a scene's voxels ask of a format.
#include "voxc/Search/SceneValues.h"

#include "Construct/Nodes/ValueStore.h"

#include <algorithm>
#include <bit>

namespace voxc {

namespace {

/// Of the largest palette.
constexpr int kMostPaletteBits = 16;

/// A build's stores, of a layout without levels.
struct Store {
  Store(WordStore words, VoxelFacts facts, const std::shared_ptr<WorkingMemory> &memory)
      : nodes(std::move(words), Layout{}, memory), values(nodes, facts, memory) {}

  static Expected<std::unique_ptr<Store>> create(VoxelFacts facts,
                                                 const std::shared_ptr<WorkingMemory> &memory) {
    auto words = VOXC_TRY(WordStore::create(memory));
    return std::make_unique<Store>(std::move(words), facts, memory);
  }

  /// Words of the values.
  Expected<std::uint64_t> finish() {
    WordStore &words = nodes.words();
    const std::uint64_t before = words.size();
    values.finish(words, kMaxWords);
    if (nodes.failure())
      return *nodes.failure();
    return words.size() - before;
  }

  NodeStore nodes;
  ValueStore values;
};

} // namespace

struct SceneValues::Stores {
  std::unique_ptr<Store> plain;
  std::unique_ptr<Store> palette; ///< It fails where there are too many colours, which is no failure here.
};

SceneValues::SceneValues(std::unique_ptr<Stores> stores) : stores_(std::move(stores)) {}
SceneValues::~SceneValues() = default;
SceneValues::SceneValues(SceneValues &&) noexcept = default;
SceneValues &SceneValues::operator=(SceneValues &&) noexcept = default;

Expected<SceneValues> SceneValues::create(const std::shared_ptr<WorkingMemory> &memory) {
  auto plain = VOXC_TRY(Store::create({}, memory));
  auto palette = VOXC_TRY(Store::create(VoxelFacts::ofPalette(kMostPaletteBits), memory));
  return SceneValues(std::make_unique<Stores>(Stores{std::move(plain), std::move(palette)}));
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
    stores_->plain->values.put({&cell, 1});
    stores_->palette->values.put({&cell, 1});
  }
}

Expected<SceneValues::Cheapest> SceneValues::finish() {
  const auto plain = VOXC_TRY(stores_->plain->finish());
  const auto palette = stores_->palette->finish();
  // Those of the last block are there only now.
  const auto colours = static_cast<std::uint32_t>(stores_->palette->values.colours());
  if (!palette || *palette >= plain || colours == 0)
    return Cheapest{plain, 0};
  return Cheapest{*palette, std::max(static_cast<int>(std::bit_width(colours - 1)), 1)};
}

} // namespace voxc
