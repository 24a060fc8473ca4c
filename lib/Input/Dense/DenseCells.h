// The cells of a dense volume, whatever the order in which they are stored.
#pragma once

#include "Input/Dense/DenseVolume.h"
#include "Source/DenseSource.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace voxc {

/// Copies `count` samples, each `step` bytes behind the one before, to `target` without gaps.
void gatherSamples(const std::byte *first, std::int64_t step, std::size_t count, std::size_t sampleBytes,
                   std::byte *target);

using PieceVisitor = std::function<void(const std::byte *samples, std::size_t count)>;

/// Calls `visit(samples, count)` with all samples of a volume, some at a time and without gaps, in whatever
/// order they are read fastest. Error: interrupted.
Expected<void> forEachPiece(const DenseVolume &volume, const InputOptions &options,
                            const PieceVisitor &visit);

/// Rows of words: what `map` makes of each sample, or the colours of a volume of several channels.
std::shared_ptr<const DenseRows> makeRows(DenseVolume volume, const SampleMap &map);

} // namespace voxc
