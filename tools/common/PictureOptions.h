// The options of a picture: its style, its samples, its light, and where it is taken from.
#pragma once

#include "CameraOptions.h"
#include "Json.h"

#include "voxc/Render/Render.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

/// As they were written; "" or 0 is the default.
struct PictureOptions {
  std::string style = "lit";
  unsigned samples = 0;
  std::string normals = "auto";
  std::vector<double> sun; ///< Azimuth and elevation in degrees.
  std::string view;        ///< A word; by default auto, or none beside --camera.
  double lod = 0;          ///< Pixels.
  double coarse = 0;       ///< Pixels.
  CameraOptions camera;
};

/// Adds --style, --samples, --normals, --sun, --view and the camera's options to a command.
void addPictureOptions(const CommandLine &command, PictureOptions &options);

/// Adds --sun and --view alone.
void addViewOptions(const CommandLine &command, PictureOptions &options);

/// Looks at the options before any work: whatever the volume will be, they are right or wrong for any.
/// Errors: `Usage`; `Input`, a camera file that is missing or broken.
Expected<void> checkPictureOptions(const PictureOptions &options);

/// Refuses what goes by how small things look for a camera of parallel rays, which a file may have. Error:
/// `Usage`.
Expected<void> checkLens(const PictureOptions &options, const Camera &camera);

/// Towards the sun.
glm::dvec3 sunOf(const PictureOptions &options);

Style styleOf(const PictureOptions &options);

/// How a volume is rendered by the options.
RenderOptions renderOptions(const PictureOptions &options, const Volume &volume);

/// A camera, and what is to be said of it.
struct PlacedCamera {
  Camera camera;
  std::string view;    ///< Its word; "" if it was given by numbers or by a file.
  bool isAuto = false; ///< Nobody has asked for this view.
};

/// Where from; the rays by which a view is found go to `trace`. Errors: those of tracing; an empty volume has
/// no view.
Expected<PlacedCamera> placeCamera(const PictureOptions &options, const Volume &volume, TraceRays trace);
/// Whether the picture takes surfaces from the voxels around those that are hit, and so a volume with its
/// words.
bool looksAround(const PictureOptions &options, const VolumeInfo &info);

struct TakenPicture {
  Rendering rendering;
  PlacedCamera placed;
};

/// Takes the picture; the rays by which a view is found go to `probe`. Errors: those of tracing; an empty
/// volume has no view.
Expected<TakenPicture> takePicture(const PictureOptions &options, const Volume &volume,
                                   const RenderTracers &tracers, TraceRays probe, unsigned threads,
                                   const Progress &progress);

/// Writes it to `path`, in the kind that its ending says.
Expected<void> writeTaken(const std::string &path, const TakenPicture &taken);

/// Adds `camera`, as options, and of a view `view`, with `view_is_auto` where nobody asked for it.
void addCameraFigures(Json &figures, const PictureOptions &options, const PlacedCamera &placed,
                      const Volume &volume);

/// The camera that was used as options: "--camera ... --fov ...", in the units that it was given in.
std::string cameraText(const PictureOptions &options, const Camera &camera, const Volume &volume);

/// What is odd about where the camera stands, in a sentence: in a voxel, right before a wall, with nothing in
/// sight. Nothing if all is well.
/// With something cut away the voxel in which the camera stands is cut away too.
std::optional<std::string> cameraWarning(const TakenPicture &taken, const Volume &volume,
                                         bool isClipped = false);

} // namespace voxc::tool
