// Random formats of a given size, for property tests and for `voxc-hard-rays`.
#pragma once

#include "voxc/IR/Format.h"

#include <random>
#include <string>

namespace voxc::test {

/// A number in [low, high], the same for a seed with every standard library.
int pick(std::mt19937 &random, int low, int high);

/// A format string of 1 to 5 levels, 2^log2Side voxels on its longest axis; now and then not a cube.
std::string randomFormatText(std::mt19937 &random, int log2Side);

/// The format with random storage passes, and with a traversal: every traversal is as likely as the others.
Format withRandomPasses(std::mt19937 &random, Format format);

/// A parsed random format with random passes.
Format randomFormat(std::mt19937 &random, int log2Side);

} // namespace voxc::test
