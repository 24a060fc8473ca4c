// What the functions of a constructor share.
#pragma once

#include "WholeBuild.h"

#include "voxc/Construct/Constructor.h"

#include <memory>

namespace voxc {

struct Constructor::State {
  ConstructionOfFormat construction;
  double compileSeconds;

  const Format &format() const { return construction.format; }
  const Layout &layout() const { return construction.layout; }
  const ConstructCode &functions() const { return construction.functions; }
};

/// Error (`Input`): more voxels along an axis than the format holds.
Expected<void> checkFits(Int3 extent, const Format &format);

/// The source in the colours that the payload keeps, if it rounds them; else null.
std::unique_ptr<RoundedSource> roundedAs(const Layout &layout, VoxelSource &source);

/// The options with the default memory where none was given.
BuildOptions withMemory(BuildOptions options);

/// What a volume of a source says of itself before its voxels are counted.
VolumeInfo infoOf(const VoxelSource &source, const Format &format, const BuildOptions &options);

} // namespace voxc
