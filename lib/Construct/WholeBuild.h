// From voxels, or from parts, to a whole volume.
#pragma once

#include "Construct/Host/ConstructCode.h"
#include "Construct/Parts/PartStream.h"
#include "VolumeBuild.h"

#include "Jit/Jit.h"
#include "voxc/Construct/Constructor.h"

namespace voxc {

/// Construction code of a format, and how it lays words.
struct ConstructionOfFormat {
  Format format; ///< As volumes store it.
  Layout layout;
  JitCode code;
  ConstructCode functions; ///< Of `code`.

  /// Errors: as of `Constructor::compile`.
  static Expected<ConstructionOfFormat> compile(const Format &format, const CompileCache *cache = nullptr);
};

/// Builds the volume of a source in one go. `emptyWords` are left before the first node: they change the
/// volume's bytes and no voxel, so that nodes lie where they do in very large volumes alone. `options.memory`
/// is set.
BuildResult buildWhole(VoxelSource &source, const ConstructionOfFormat &construction,
                       const BuildOptions &options, std::uint64_t emptyWords = 0);

/// Joins the parts of a stream to a volume.
BuildResult joinParts(PartStream &parts, VolumeInfo info, const ConstructionOfFormat &construction,
                      const BuildOptions &options, Origin origin);

} // namespace voxc
