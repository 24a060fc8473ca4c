// The options that say where a picture is taken from.
#pragma once

#include "CameraFile.h"
#include "CommandLine.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"
#include "voxc/Trace/Camera.h"

#include <array>
#include <string>

namespace voxc::tool {

/// As they were written; empty or 0 is the default.
struct CameraOptions {
  /// "EX,EY,EZ:LX,LY,LZ" (eye and a point looked at, in voxels, or after `kModelUnits` in those of the model)
  /// or "FILE.json:NAME" (see CameraFile.h); by default the camera frames the whole volume.
  std::string camera;
  std::string size; ///< "WIDTHxHEIGHT"; by default the camera file's, or 1280x720.
  double fov = 0;   ///< Vertical field of view in degrees; by default the camera's, 90 in files, else 60.
  bool orthographic = false;
  double viewHeight = 0;    ///< Of an orthographic camera, in voxels; by default what a pinhole would show.
  bool cubicVoxels = false; ///< Voxels are drawn as cubes, whatever the spacing of the scan.
};

/// What stands before the points of a camera in the units of the model.
inline constexpr const char *kModelUnits = "model:";

/// Whether the camera is given in them.
bool isInModelUnits(const CameraOptions &options);

/// Whether the camera is to be orthographic, whatever place it is given.
bool isOrthographic(const CameraOptions &options);

/// The sides of voxels in the picture: those of a volume whose units are the model's by `voxelToModel`.
glm::dvec3 spacingOf(const CameraOptions &options, const Transform &voxelToModel);

/// Adds --camera, --fov, --orthographic, --view-height and --cubic-voxels to a command.
void addCameraPlace(const CommandLine &command, CameraOptions &options);

/// The same, and --size.
void addCameraOptions(const CommandLine &command, CameraOptions &options);

/// The camera for a volume of `extent` voxels whose units are the model's by `voxelToModel`. Errors: `Usage`
/// for a malformed option, `Input` for a camera file that is missing or broken, naming the cameras there are.
Expected<Camera> makeCamera(const CameraOptions &options, Int3 extent, const Transform &voxelToModel = {});

/// A camera of a file for a volume of `extent` voxels, with the size and the field of view of the options
/// where they have them, whatever camera they name. Error: `Usage` for a malformed one of these, or if it is
/// to be orthographic and nothing says how much it shows.
Expected<Camera> makeCamera(const CameraOptions &options, const FileCamera &camera, Int3 extent,
                            const Transform &voxelToModel = {});

/// "WIDTHxHEIGHT" as two integers from 1 to 32768. Error: `Usage`.
Expected<std::array<int, 2>> parseSize(const std::string &text);

} // namespace voxc::tool
