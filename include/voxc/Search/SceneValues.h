// What the values of a scene's voxels ask of a format, and how many words they take apart from their shape.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace voxc {

class SceneValues {
public:
  /// Memory is that of a build that keeps the values, twice.
  static Expected<SceneValues> create(const std::shared_ptr<WorkingMemory> &memory);
  ~SceneValues();
  SceneValues(SceneValues &&) noexcept;
  SceneValues &operator=(SceneValues &&) noexcept;

  /// Takes words of cells in Morton order; 0 is an empty cell.
  void add(std::span<const std::uint32_t> cells);

  std::uint64_t voxels() const { return voxels_; }
  /// All voxels have one value.
  bool isOne() const { return isOne_; }
  /// No voxel has an alpha of 0.
  bool isVisible() const { return isVisible_; }

  /// The payload, without loss, whose values take the fewest words apart, and those words.
  struct Cheapest {
    std::uint64_t words = 0;
    int paletteBits = 0; ///< Of `palette(n)`; 0: there is no palette.
  };

  /// Nothing can be added afterwards. Errors: those of a build.
  Expected<Cheapest> finish();

private:
  struct Stores;
  explicit SceneValues(std::unique_ptr<Stores> stores);

  std::unique_ptr<Stores> stores_;
  std::uint64_t voxels_ = 0;
  std::optional<std::uint32_t> first_;
  bool isOne_ = true;
  bool isVisible_ = true;
};

} // namespace voxc
