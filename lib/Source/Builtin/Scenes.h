// The built-in scenes, and what they share.
#pragma once

#include "voxc/Source/VoxelSource.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// A well-mixed number for each set of coordinates and seed: the same on every machine.
constexpr std::uint32_t hashCell(Int3 cell, std::uint32_t seed) {
  std::uint32_t hash = seed * 0x9e3779b9u;
  for (const std::int32_t coordinate : {cell.x, cell.y, cell.z}) {
    hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0x85ebca6bu;
    hash = (hash ^ hash >> 15) * 0xc2b2ae35u;
  }
  return hash ^ hash >> 16;
}

std::unique_ptr<VoxelSource> makeTerrain(int side);
std::unique_ptr<VoxelSource> makeShell(int side);
std::unique_ptr<VoxelSource> makeMenger(int side);
std::unique_ptr<VoxelSource> makeFull(int side);
std::unique_ptr<VoxelSource> makeEmpty(int side);
std::unique_ptr<VoxelSource> makeVoxel(int side);
std::unique_ptr<VoxelSource> makeCorners(int side);
std::unique_ptr<VoxelSource> makeChecker(int side);
std::unique_ptr<VoxelSource> makeDust(int side);

} // namespace voxc
