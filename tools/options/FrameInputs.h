// The frames of an INPUT, one after the other.
#pragma once

#include "voxc/Construct/Frames.h"
#include "voxc/Input/Input.h"

#include <memory>
#include <string>

namespace voxc::tool {

/// Opens the frames of an animation in a file. `first` is that of frame 1, which was opened by these options,
/// whose box is that of all frames.
OpenFrame makeFrameInputs(const std::string &input, std::unique_ptr<VoxelSource> first, InputOptions options);

} // namespace voxc::tool
