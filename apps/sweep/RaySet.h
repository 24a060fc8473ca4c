// The rays of a sweep: those of cameras, or of files.
#pragma once

#include "common/OrderOption.h"
#include "voxc/Measure/MeasuredSet.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Ray.h"

#include <functional>
#include <string>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

/// Rays that wait for a volume: where a camera stands depends on the volume's extent.
struct RaySet {
  RaysPart part;
  std::function<Camera(Int3 extent)> camera; ///< Empty for rays from a file.
  std::vector<Ray> rays;                     ///< Of a file.
  std::string cameraText;                    ///< A camera file with this camera alone, named "camera".

  /// The rays through a volume of this extent.
  std::vector<Ray> raysFor(Int3 extent) const { return camera ? cameraRays(camera(extent)) : rays; }
};

/// Rays as those of a file of this name, to be taken in this order. Precondition: there is one at least.
RaySet makeRaySet(const std::string &name, std::vector<Ray> rays, const std::string &order = kAutoOrder);

/// What a machine needs to make the rays again: a "camera" of a file, the "overview" of a whole volume, or
/// the rays of a "file".
std::string kindOf(const RaysPart &part);

/// The name of the file that is kept for that, or "" where none is needed.
std::string rayFileName(const RaysPart &part);

/// Keeps that file in `folder`. Error: `Environment`.
Expected<void> keepRays(const RaySet &set, const std::string &folder);

/// The rays that `keepRays` kept in `folder`, through a volume of this extent. Error: `Input` if they cannot
/// be read.
Expected<std::vector<Ray>> keptRays(const RaysPart &part, const std::string &folder, Int3 extent);

/// What the command line says of rays.
struct RayArguments {
  std::string cameraFile; ///< "": a camera that sees the whole volume, unless there are ray files.
  std::string size;       ///< "WxH", or "": the camera file's, or 1280x720.
  std::vector<std::string> rayFiles;
  std::string order = kAutoOrder; ///< As --order says.
};

/// The rays for a model: the camera of its name, or all cameras of the file if none has it; and every ray
/// file. Errors: `Usage` for a size, `Input` for a file that is missing, broken or empty.
Expected<std::vector<RaySet>> readRaySets(const RayArguments &arguments, const std::string &model);

} // namespace voxc::tool::bench
