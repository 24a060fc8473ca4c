// A source that numbers what it meets.
#include "Source/Export/LookedVoxels.h"

#include "Source/CubeTools.h"
#include "voxc/Source/Sources.h"

#include <array>

namespace voxc {

class LookedVoxels::Source final : public VoxelSource {
public:
  Source(LookedVoxels &voxels, std::unique_ptr<VoxelSource> words)
      : voxels_(voxels), words_(std::move(words)) {}

  Int3 extent() const override { return words_->extent(); }
  bool empty(const Cube &cube) override { return words_->empty(cube); }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    VOXC_TRY(words_->read(cube, words));
    std::array<std::uint32_t, 512> looks{};
    const std::uint64_t first = mortonCode(cube.low);
    const VoxelLooks::Range said = voxels_.looks_.between(first, first + cellCount(cube.log2Side));
    for (std::size_t i = 0; i < said.codes.size(); ++i)
      looks[said.codes[i] - first] = said.looks[i];
    for (std::uint64_t i = 0; i < cellCount(cube.log2Side); ++i)
      if (words[i] != 0)
        words[i] = voxels_.numberOf({words[i], looks[i]});
    return {};
  }

private:
  LookedVoxels &voxels_;
  std::unique_ptr<VoxelSource> words_;
};

std::unique_ptr<VoxelSource> LookedVoxels::source() {
  auto words = makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume_));
  if (!looks_.areAny())
    return words;
  return std::make_unique<Source>(*this, std::move(words));
}

std::uint32_t LookedVoxels::numberOf(const Pair &pair) {
  const auto [entry, isNew] = numbers_.try_emplace(pair, static_cast<std::uint32_t>(pairs_.size() + 1));
  if (isNew)
    pairs_.push_back(pair);
  return entry->second;
}

} // namespace voxc
