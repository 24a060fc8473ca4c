// What the functions of a constructor share.
#pragma once

#include "ConstructCode.h"

#include "Jit/Jit.h"
#include "voxc/Construct/Constructor.h"

#include <memory>

namespace voxc {

struct Constructor::State {
  Format format;
  JitCode code;
  ConstructCode functions;
  double compileSeconds;
};

/// Error (`Input`): more voxels along an axis than the format holds.
Expected<void> checkFits(Int3 extent, const Format &format);

/// The source in the colours that the format's payload keeps, if it rounds them; else null.
std::unique_ptr<RoundedSource> roundedAs(const Format &format, VoxelSource &source);

/// The options with the default memory where none was given.
BuildOptions withMemory(BuildOptions options);

/// What a volume of a source says of itself before its voxels are counted.
VolumeInfo infoOf(const VoxelSource &source, const Format &format, const BuildOptions &options);

} // namespace voxc
