// Sources that voxc brings: built-in scenes, dense grids, lists of voxels, and finished volumes.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// A built-in scene, made by arithmetic on integers alone: the same on every machine.
struct BuiltinScene {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<VoxelSource> (*make)(int side);
};

/// All built-in scenes: terrain, shell, menger, full, empty, voxel, corners, checker, dust.
std::span<const BuiltinScene> builtinScenes();

/// The scene `name` with `side` voxels an axis (1 to 2^21). Error: no such scene, naming those there are.
Expected<std::unique_ptr<VoxelSource>> makeBuiltinSource(std::string_view name, int side);

/// A dense grid of RGBA words, x fastest, then y, then z; `words` has extent.x * extent.y * extent.z of them.
std::unique_ptr<VoxelSource> makeGridSource(Int3 extent, std::vector<std::uint32_t> words);

/// A dense grid in a file of little-endian words, which is mapped and watched by `memory`. Errors:
/// unreadable, not exactly the right size, interrupted.
Expected<std::unique_ptr<VoxelSource>> loadGridSource(Int3 extent, const std::string &path,
                                                      std::shared_ptr<WorkingMemory> memory,
                                                      const Progress &progress = {});

/// One voxel of a list.
struct CodedVoxel {
  std::uint64_t code; ///< Morton code.
  std::uint32_t word;
  std::uint32_t order = 0; ///< Its number in an unsorted list: of several with one code the lowest counts.
};

/// Voxels sorted by Morton code, each code once, no word 0.
std::unique_ptr<VoxelSource> makeSortedSource(Int3 extent, std::vector<CodedVoxel> voxels,
                                              Transform voxelToModel = {});

/// A finished volume, to be converted. The volume must outlive the source if it is passed by reference.
std::unique_ptr<VoxelSource> makeVolumeSource(std::shared_ptr<const Volume> volume);

} // namespace voxc
