// Proving and choosing frames while a volume is loaded.
#pragma once

#include "voxc/Volume/Frames.h"

namespace voxc {

/// Error (`Input`): the stream of frames is not what it has to be. Where roots lead is for `checkStructure`.
Expected<void> checkFrames(const Volume &volume);

/// Error (`Input`): of `frames` there is none of this number, from 1 on; "it has no frame 7; there are 3".
Expected<void> checkFrameNumber(int number, std::uint64_t frames);

} // namespace voxc
