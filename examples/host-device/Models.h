// The two models: every voxel by arithmetic, as a word of its colour; 0 is empty.
#pragma once

#include <voxc/Source/VoxelSource.h>

#include <cstdint>

constexpr voxc::Int3 kSpongeSize{81, 81, 81};
std::uint32_t spongeVoxel(voxc::Int3 cell);

constexpr voxc::Int3 kRingSize{128, 128, 16};
std::uint32_t ringVoxel(voxc::Int3 cell);
