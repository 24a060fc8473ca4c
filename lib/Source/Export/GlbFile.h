// A .glb file of one mesh, whose head is written last.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace voxc {

/// The least and the greatest position of a mesh, as text of glTF.
class PositionBounds {
public:
  void add(const std::array<float, 3> &position);
  /// The members "min" and "max" of an accessor.
  std::string text() const;

private:
  static constexpr float kFar = std::numeric_limits<float>::max();
  std::array<float, 3> low_{kFar, kFar, kFar};
  std::array<float, 3> high_{};
};

/// Where the corner of a voxel is, in voxels, which float32 holds exactly.
inline std::array<float, 3> positionOf(Int3 corner) {
  return {static_cast<float>(corner.x), static_cast<float>(corner.y), static_cast<float>(corner.z)};
}

/// A number as text, such that float32 has it again.
std::string jsonNumber(double number);

/// A binary glTF 2.0 file: room for its head, the bytes of its buffer as they come, and then the head.
class GlbFile {
public:
  /// The file, which must be one that can be rewritten, must outlive this.
  explicit GlbFile(OutputFile &file) : file_(file) {}

  /// Leaves room for the head of so many materials with a primitive each. Errors: the file's; a pipe.
  Expected<void> begin(std::size_t materials = 1);
  /// Adds bytes to the buffer. Errors: the file's; more than 4 GiB, which a .glb cannot say.
  Expected<void> write(const void *bytes, std::uint64_t size);
  /// So many bytes has the buffer.
  std::uint64_t bytes() const { return bytes_; }
  /// Ends the buffer and writes the head: `mesh` has the members "meshes" and all that it takes but the
  /// buffer, below 1500 bytes and 768 more for each further material; empty for a model without a mesh, as
  /// glTF has no empty accessors. Errors: the file's.
  Expected<void> finish(const std::string &mesh, const Transform &voxelToModel);

private:
  std::uint32_t binaryOffset() const { return 12 + 8 + jsonBytes_ + 8; }

  OutputFile &file_;
  std::uint32_t jsonBytes_ = 0; ///< Of the head's text.
  std::uint64_t bytes_ = 0;
};

} // namespace voxc
