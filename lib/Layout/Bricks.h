// Bricks: grids of 4 x 4 x 4 cells, whose mask is two words.
#pragma once

#include "voxc/Layout/SlotKind.h"

#include <cstdint>
#include <string>

namespace voxc {

/// Its shape, or what is wrong with it.
std::string brickProblem(const Stratum &stratum);

/// The mask at the head of a brick, x fastest, then y, then z.
std::uint64_t brickMask(const WordReader &words, std::uint64_t brick);

/// The bits of octants of a brick that are not empty, of which bit 2x + 8y + 32z stands for octant (x, y, z):
/// that of its first cell.
std::uint64_t brickOctants(std::uint64_t mask);

/// A mask with its bits in Morton order.
std::uint64_t inMortonOrder(std::uint64_t mask);

EmptyRegion brickRegion(const Stratum &stratum);

} // namespace voxc
