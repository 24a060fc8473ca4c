// Voxels in a tree of 32-bit numbers, set one by one as OpenVDB does it.
#include "VdbEdits.h"

#ifdef VOXC_HAS_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>
#endif

namespace voxc::edits {

#ifdef VOXC_HAS_OPENVDB
namespace {

class Accessed final : public VdbEdits {
public:
  explicit Accessed(const Volume &volume) : grid_(openvdb::Int32Grid::create(0)) {
    auto accessor = grid_->getAccessor();
    static_cast<void>(decode(volume, [&](const Cube &cube, std::uint32_t word) {
      const auto side = static_cast<int>(cube.side());
      for (int i = 0; i < side * side * side; ++i)
        accessor.setValue(coordOf(cube.low + Int3{i % side, i / side % side, i / (side * side)}), int(word));
      return true;
    }));
  }

  void apply(const Edit &edit, const std::vector<VoxelWord> &pasted) override {
    auto accessor = grid_->getAccessor();
    const auto set = [&](Int3 at, std::uint32_t word) {
      if (word == 0)
        accessor.setValueOff(coordOf(at), 0);
      else
        accessor.setValue(coordOf(at), int(word));
    };
    if (edit.shape == Edit::Voxel)
      return set(edit.at, edit.word);
    if (edit.shape == Edit::Paste) {
      for (const VoxelWord &voxel : pasted)
        set(edit.at + voxel.at, voxel.word);
      return;
    }
    const int radius = edit.radius;
    for (int x = -radius; x <= radius; ++x)
      for (int y = -radius; y <= radius; ++y)
        for (int z = -radius; z <= radius; ++z)
          if (x * x + y * y + z * z <= radius * radius)
            set(edit.at + Int3{x, y, z}, edit.word);
  }

  std::uint64_t bytes() const override { return grid_->memUsage(); }

private:
  static openvdb::Coord coordOf(Int3 at) { return {at.x, at.y, at.z}; }
  openvdb::Int32Grid::Ptr grid_;
};

} // namespace

std::unique_ptr<VdbEdits> VdbEdits::create(const Volume &volume) {
  openvdb::initialize();
  return std::make_unique<Accessed>(volume);
}
#else
std::unique_ptr<VdbEdits> VdbEdits::create(const Volume &) { return nullptr; }
#endif

} // namespace voxc::edits
