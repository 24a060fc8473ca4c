// A volume as one page for browsers, which needs nothing beside it.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Render/Picture.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Clip.h"
#include "voxc/Volume/Volume.h"

#include "page/CheckRays.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxc::page {

/// A compressed volume that a page does not hold, but reads page by page.
struct StreamedVolume {
  std::string url;         ///< Where from, as seen from the page.
  std::uint64_t headBytes; ///< As `PagedVolume` has them.
  std::uint64_t fileBytes;
  std::uint64_t checksum; ///< Of the head.
  std::uint32_t pageBytes;
  std::uint64_t memoryBytes;        ///< For pages and their table, at most.
  PictureView view;                 ///< Whose rays the page checks.
  std::vector<std::uint32_t> first; ///< Pages to ask for before any ray does.
};

/// What a page says and shows beside the volume.
struct PageContents {
  std::string title;
  Picture picture;     ///< Taken by `camera`: what is to be seen until the page has a picture of its own.
  Camera camera;       ///< With which it begins. What is level is level in its picture.
  Clip clip;           ///< What is seen, `scaled`.
  glm::dvec3 sun;      ///< Towards it; of any length but 0.
  bool smooth = false; ///< Surfaces have the direction of their neighbourhood, as `RenderOptions::isSmooth`.
  float exposure;      ///< That makes a picture of the light.
  ErrorFigures fast;   ///< Of fast arithmetic.
  std::string checks;  ///< `digestsOf` the exact hits of the first of `checkRays`, or of `pictureRays` if
                       ///< streamed, within what `clip` keeps.
  std::optional<StreamedVolume> streamed; ///< Else the page holds the words.
};

/// The same planes by numbers that float32 holds: the longest side of each normal is 1.
Clip scaled(Clip clip);

/// More words than this are more than browsers keep in a texture: 4096 places a row, 16384 rows.
inline constexpr std::size_t kMostWords = std::size_t{4096} * 16384;

/// The page. Errors: `Input`, more than `kMostWords` in a page that holds them.
Expected<std::string> makePage(const Volume &volume, const PageContents &contents);

} // namespace voxc::page
