// Volumes of several frames, such as an animation: each frame is an edit of the one before it, so that all
// share what is equal.
#pragma once

#include "voxc/Construct/Constructor.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace voxc {

/// Opens the voxels of frame `index`, from 0 on; each frame is asked for once, in their order.
using OpenFrame = std::function<Expected<std::unique_ptr<VoxelSource>>(std::size_t index)>;

/// What one frame added.
struct FrameReport {
  std::uint64_t voxels = 0;  ///< Of the frame,
  std::uint64_t changed = 0; ///< that differ from the frame before, cleared ones too,
  std::uint64_t words = 0;   ///< and the words that it does not share with earlier frames.
};

struct BuiltFrames {
  Volume volume;      ///< With a stream of frames (`voxc/Volume/Frames.h`).
  BuildReport report; ///< Of the first frame.
  std::vector<FrameReport> frames;
};

/// Builds `count` frames, at least one, into one volume. Frames lie in the extent of the first. The bytes
/// depend on format and voxels alone. `options.path` and `compress` say where the volume is written. Errors:
/// a format that cannot be edited (`Input`, naming why); a larger frame; those of `open`; as
/// `Constructor::build`.
Expected<BuiltFrames> buildFrames(const Format &format, std::size_t count, const OpenFrame &open,
                                  const BuildOptions &options = {}, const CompileCache *cache = nullptr);

} // namespace voxc
