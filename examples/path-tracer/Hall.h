// The scene: a hall of columns under an open roof, with a sponge that has a lamp in it, over a pool.
#pragma once

#include <voxc/Source/VoxelSource.h>

#include <cstdint>

constexpr voxc::Int3 kHallSize{256, 128, 256};

/// The word of a voxel: its colour, and in place of alpha what it is made of; 0 is empty.
std::uint32_t hallVoxel(voxc::Int3 cell);
