// A finished volume as a source, to convert it to another format.
#include "voxc/Source/Sources.h"

#include "Source/CubeTools.h"
#include "Volume/Decode.h"

#include <utility>

namespace voxc {

namespace {

class VolumeSource final : public VoxelSource {
public:
  explicit VolumeSource(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}

  Int3 extent() const override { return volume_->info().extent; }
  Transform voxelToModel() const override { return volume_->info().voxelToModel; }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<VolumeSource>(volume_); }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent()))
      return true;
    const Lookup found = volume_->lookup(cube.low);
    return found.value == 0 && found.log2Side >= cube.log2Side;
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    readCube(*volume_, cube, words);
    return {};
  }

private:
  std::shared_ptr<const Volume> volume_;
};

} // namespace

std::unique_ptr<VoxelSource> makeVolumeSource(std::shared_ptr<const Volume> volume) {
  return std::make_unique<VolumeSource>(std::move(volume));
}

} // namespace voxc
