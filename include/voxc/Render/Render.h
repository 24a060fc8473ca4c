// Pictures of a volume: rays through pixels, rays to the sun and the sky, and what becomes of them.
#pragma once

#include "voxc/Render/Picture.h"
#include "voxc/Render/Style.h"
#include "voxc/Render/SurfaceNormals.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/FunctionRef.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Clip.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// Traces rays[i] into hits[i], as `Tracer::trace` does.
using TraceRays =
    FunctionRef<Expected<void>(std::span<const Ray> rays, std::span<Hit> hits, const TraceOptions &options)>;

struct RenderTracers {
  TraceRays camera;    ///< Hits with voxel, t and colour.
  TraceRays occlusion; ///< Hits with t alone; may be the same.
};

struct RenderOptions {
  Style style = Style::Lit;
  unsigned samples = 0;  ///< Rays a pixel; 0: the style's own number.
  bool isSmooth = false; ///< Surfaces have the direction of their neighbourhood, not of a voxel's face.
  /// Normals that other pictures of this volume have found, to which this one adds; null: it finds its own.
  SurfaceNormals *normals = nullptr;
  /// What of the volume the tracers see: surfaces at its cuts lie in its planes; null: all of it.
  const Clip *clip = nullptr;
  /// Looks for no normals beyond those: other surfaces show their faces, as they do in a first draft.
  bool isDraft = false;
  glm::dvec3 sun{-0.42, 0.76, 0.5}; ///< Towards it; of any length but 0.
  double lod = 0; ///< Pixels below which the kernel may stop (`TraceOptions::spread`); 0: none.
  /// Pixels below which coarse blocks may stand in for pages (`TraceOptions::coarse`), for rays of the eye
  /// and to the light; 0: none may.
  double coarse = 0;
  unsigned threads = 0; ///< That shade; 0: all of the machine.
  Progress progress;
};

/// A picture, and the light that it is made of.
struct Rendering {
  Picture picture;
  /// Four numbers a pixel: linear red, green and blue of what was hit, before exposure, times the share of
  /// the pixel that was hit, and that share. Of maps, red is the number that is mapped.
  std::vector<float> light;
  float exposure = 1; ///< That made the picture of the light.
  double nearest = 0; ///< From the eye to the nearest hit, in voxels; 0 if nothing was hit.
  double middle = 0;  ///< Half of the hits are nearer than this, of one ray a pixel; 0 if none of these hit.
  std::uint64_t hits = 0; ///< Of all rays of the eye.
};

/// Takes a picture. It depends on nothing but the arguments (drafts on the normals that are known), and not
/// on the number of threads. Errors: those of tracing; interrupted.
Expected<Rendering> render(const Volume &volume, const Camera &camera, const RenderTracers &tracers,
                           const RenderOptions &options);

/// Whether the voxels of a volume stand for a surface that is not meant to be blocky: those of meshes, points
/// and samples, by what its header says of their making. Voxel art and built-in scenes are blocky.
bool isSmoothSurface(const VolumeInfo &info);

} // namespace voxc
