// Named attributes: what is known of each voxel beside its value, such as a normal, a density or a label. An
// attribute is a stream with one element for each voxel, by the voxel's number: how many voxels of the volume
// come before it. They are counted in Morton order, but inside of a last level's masked grid that is not
// M(2, 2, 2) along x first, then y, then z, as its bits are. Where values stand apart, a kernel with
// `index=yes` reports the number of a hit's voxel (`Outputs::index`).
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct Attribute {
  std::string name;               ///< As `Stream::name`, but not `words` or `frames`.
  std::uint32_t elementBytes = 4; ///< 1 to 256.
  std::vector<std::byte> elements;
};

/// What elements may take by default: a small file may stand for very many voxels.
inline constexpr std::uint64_t kMostAttributeBytes = std::uint64_t{1} << 34;

/// Zeros, one element of so many bytes for each voxel. Error (`Input`): they would take more than
/// `mostBytes`.
Expected<std::vector<std::byte>> zeroElements(const Volume &volume, std::uint32_t elementBytes,
                                              std::uint64_t mostBytes = kMostAttributeBytes);

/// Receives a voxel and its number; false ends the visit.
using VoxelVisit = std::function<bool(Int3 voxel, std::uint64_t number)>;

/// Calls `visit` for each voxel that is not empty, in Morton order. All numbers are below `info().voxels`.
/// Errors: as `decode`.
Expected<void> visitVoxels(const Volume &volume, const VoxelVisit &visit, const Progress &progress = {});

/// A volume of the same words with one attribute more, or another in place of one of that name. It keeps
/// `volume`. Errors (`Usage`): no possible name or size of elements, not one element for each voxel, more
/// than 63 attributes.
Expected<Volume> withAttribute(std::shared_ptr<const Volume> volume, Attribute attribute);

/// The same without one. Error (`Usage`): there is none of that name.
Expected<Volume> withoutAttribute(std::shared_ptr<const Volume> volume, std::string_view name);

/// The attribute of this name, or null: of a stream from a file no one else says that it has an element for
/// each voxel.
const Stream *findAttribute(const Volume &volume, std::string_view name);

} // namespace voxc
