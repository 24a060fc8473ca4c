// A volume as one page for browsers, which needs nothing beside it.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Volume/Volume.h"

#include <glm/vec3.hpp>

#include <string>

namespace voxc::page {

/// What a page says and shows beside the volume.
struct PageContents {
  std::string title;
  Camera camera;       ///< With which it begins. What is level is level in its picture.
  glm::dvec3 sun;      ///< Towards it; of any length but 0.
  bool smooth = false; ///< Surfaces have the direction of their neighbourhood, as `RenderOptions::isSmooth`.
  float exposure;      ///< That makes a picture of the light.
  ErrorFigures fast;   ///< Of fast arithmetic.
  std::string checks;  ///< `digestsOf` the exact hits of the first of `checkRays`.
};

/// More words than this are more than browsers keep in a texture: 4096 places a row, 16384 rows.
inline constexpr std::size_t kMostWords = std::size_t{4096} * 16384;

/// The page. Errors: `Input`, more than `kMostWords`.
Expected<std::string> makePage(const Volume &volume, const PageContents &contents);

} // namespace voxc::page
