// Digests of what voxc computes, which must be the same whatever compiler built it and whatever processor
// runs it.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Error.h"

#include "Volume/Checksum.h"

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace voxc::test {

/// What one computation gave, under its name.
struct NamedDigest {
  std::string name;
  std::uint64_t value;
};

/// Of the bytes of numbers; `Row` has no padding.
template <typename Row> std::uint64_t digestOf(std::span<const Row> rows) {
  static_assert(std::is_trivially_copyable_v<Row>);
  Checksum checksum;
  checksum.add(rows.data(), rows.size_bytes());
  return checksum.digest();
}

/// Of a source's extent and of all its words. Error: that of a source that fails.
Expected<std::uint64_t> digestOf(VoxelSource &source);

/// Each part adds the digests of what it computes. Error: what it could not compute, or what is wrong
/// whatever others find.
Expected<void> addVoxelDigests(std::vector<NamedDigest> &digests);
Expected<void> addCameraDigests(std::vector<NamedDigest> &digests);
/// Of `rays` hard rays, over all classes and some scenes: the rays, and their exact hits.
Expected<void> addRayDigests(std::uint64_t rays, std::vector<NamedDigest> &digests);
/// What the functions of a header find of `rays` hard rays; they must be what the oracle finds.
Expected<void> addFunctionDigests(std::uint64_t rays, std::vector<NamedDigest> &digests);

} // namespace voxc::test
