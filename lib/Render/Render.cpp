// Pictures of a volume, band by band and sample by sample.
#include "voxc/Render/Render.h"

#include "Exposure.h"
#include "LightRays.h"
#include "Lighting.h"

#include "Support/ParallelFor.h"
#include "voxc/Trace/PixelRays.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace voxc {

namespace {

/// Rays of a band: what is kept of it takes 200 MiB or so.
constexpr std::int64_t kBandRays = std::int64_t{1} << 20;

class Renderer {
public:
  Renderer(const Volume &volume, const Camera &camera, const RenderTracers &tracers,
           const RenderOptions &options)
      : volume_(volume), camera_(camera), tracers_(tracers), options_(options), kind_(kindOf(options.style)),
        samples_(options.samples > 0 ? options.samples : kind_.samples),
        sun_(glm::normalize(glm::vec3(options.sun))), spacing_(camera.spacing),
        ownNormals_(volume, options.threads), normals_(options.normals ? options.normals : &ownNormals_) {
    const Int3 extent = volume.info().extent;
    const glm::vec3 sides = glm::vec3(extent.x, extent.y, extent.z) * spacing_;
    openScale_ = 0.06f * std::max({sides.x, sides.y, sides.z, 1.0f});
  }

  Expected<Rendering> run();

private:
  bool isMap() const { return !kind_.unit.empty(); }
  bool isSmooth() const { return options_.isSmooth && kind_.needsNormals; }
  TraceOptions traceOptions() const;
  /// Calls `work(row)` for each of so many rows, on threads; not for all of them once it is to stop.
  Expected<void> forRows(int rows, FunctionRef<void(int row)> work) const;

  Expected<void> expose(Film &film, unsigned sample);
  Expected<void> gather(Film &film, const std::vector<Ray> &rays, const std::vector<Hit> &hits);
  Expected<std::vector<Ray>> raysOf(const Film &film, unsigned sample) const;
  Picture shadedFaces(std::vector<Ray> rays, const std::vector<Hit> &hits, const Film &film) const;
  void gatherPixel(FilmPixel &pixel, const Ray &ray, const Hit &hit, const Surface &surface) const;
  Expected<void> light(Film &film, unsigned sample, const std::vector<Hit> &hits) const;
  void finishDistances();
  glm::vec3 exposed(const glm::vec3 &light, float share) const;
  Expected<void> develop(const Film &film, int first, int rows);
  Expected<void> finish();
  Expected<void> finishMap();

  const Volume &volume_;
  const Camera &camera_;
  const RenderTracers &tracers_;
  const RenderOptions &options_;
  const StyleKind &kind_;
  unsigned samples_;
  glm::vec3 sun_;
  glm::vec3 spacing_; ///< Of voxels: light goes through spaced space, rays are traced in voxels.
  SurfaceNormals ownNormals_;
  SurfaceNormals *normals_;
  float openScale_;
  std::vector<Surface> surfaces_; ///< Of the rays of a band and sample; those of misses mean nothing.
  std::vector<glm::vec3> backdrop_;
  std::vector<float> distances_; ///< Of the hits of the first sample.
  Rendering result_;
};

TraceOptions Renderer::traceOptions() const {
  TraceOptions options;
  options.countSteps = options_.style == Style::Heatmap;
  options.spread = float(options_.lod * pixelSpread(camera_));
  for (int axis = 0; axis < 3; ++axis)
    options.coarse.from[axis] = float(camera_.eye[axis]);
  options.coarse.spread = float(options_.coarse * pixelSpread(camera_));
  options.progress = options_.progress.silent();
  return options;
}

Expected<void> Renderer::forRows(int rows, FunctionRef<void(int row)> work) const {
  return parallelTry(std::uint64_t(rows), options_.threads, [&](std::uint64_t row) -> Expected<void> {
    VOXC_TRY(options_.progress.check());
    work(int(row));
    return {};
  });
}

/// The rays of one sample, tile by tile.
Expected<std::vector<Ray>> Renderer::raysOf(const Film &film, unsigned sample) const {
  const PixelRays pixels(camera_, samples_ == 1 ? glm::vec2(0.5f) : evenNumbers(sample));
  const Tiles tiles(film.width, film.rows);
  std::vector<Ray> rays(film.pixels.size());
  const Expected<void> made = forRows(tiles.strips(), [&](int strip) {
    tiles.visitStrip<TileOrder::Near>(strip, [&](const TiledPixel &at) {
      rays[at.ray] = pixels.through(at.column, film.firstRow + at.row);
    });
  });
  return made ? Expected<std::vector<Ray>>(std::move(rays)) : made.error();
}

/// Adds one sample to each pixel of a band.
Expected<void> Renderer::expose(Film &film, unsigned sample) {
  const std::vector<Ray> rays = VOXC_TRY(raysOf(film, sample));
  std::vector<Hit> hits(rays.size());
  VOXC_TRY(tracers_.camera(rays, hits, traceOptions()));
  if (volume_.layout().hasLabels())
    showLabels(hits);
  result_.hits += static_cast<std::uint64_t>(std::ranges::count_if(hits, &Hit::isHit));
  if (sample == 0)
    for (const Hit &hit : hits)
      if (hit.isHit())
        distances_.push_back(hit.t);
  if (isSmooth() && !options_.isDraft)
    VOXC_TRY(normals_->learn(hits, options_.progress));
  VOXC_TRY(gather(film, rays, hits));
  return kind_.isLit ? light(film, sample, hits) : Expected<void>();
}

Expected<void> Renderer::gather(Film &film, const std::vector<Ray> &rays, const std::vector<Hit> &hits) {
  surfaces_.resize(rays.size());
  // Colours of faces are those of a screen already.
  const Picture faces = options_.style == Style::Flat ? shadedFaces(rays, hits, film) : Picture{};
  const Tiles tiles(film.width, film.rows);
  return forRows(tiles.strips(), [&](int strip) {
    tiles.visitStrip<TileOrder::Near>(strip, [&](const TiledPixel &at) {
      FilmPixel &pixel = film.pixels[at.pixel];
      const std::uint32_t i = at.ray;
      if (options_.style == Style::Flat) {
        pixel.hits += 1;
        pixel.light += linearColour(faces.pixels[i]);
        return;
      }
      if (hits[i].isHit())
        surfaces_[i] =
            spacedSurface(rays[i], hits[i], isSmooth() ? normals_ : nullptr, spacing_, options_.clip);
      gatherPixel(pixel, rays[i], hits[i], surfaces_[i]);
    });
  });
}

/// Colours of faces, ray by ray; the sky behind them is that of spaced space.
Picture Renderer::shadedFaces(std::vector<Ray> rays, const std::vector<Hit> &hits, const Film &film) const {
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (int axis = 0; axis < 3 && !hits[i].isHit(); ++axis)
      rays[i].direction[axis] *= spacing_[axis];
  return shade(rays, hits, film.width, film.rows);
}

void Renderer::gatherPixel(FilmPixel &pixel, const Ray &ray, const Hit &hit, const Surface &surface) const {
  if (options_.style == Style::Heatmap)
    pixel.value += float(hit.steps);
  if (!hit.isHit()) {
    pixel.backdrop += backdrop(vectorOf(ray.direction) * spacing_);
    return;
  }
  if (pixel.hits == 0) {
    pixel.normal = surface.normal;
    pixel.point = surface.point;
  }
  pixel.hits += 1;
  switch (options_.style) {
  case Style::Depth:
    pixel.value += hit.t;
    break;
  case Style::Normals:
    for (int axis = 0; axis < 3; ++axis)
      pixel.light[axis] += toLinear(0.5f + 0.5f * surface.normal[axis]);
    break;
  case Style::Ambient:
    pixel.skyLit += glm::vec3(1);
    break;
  case Style::Lit:
    pixel.skyLit += linearColour(hit.rgba) * skyLight(surface.normal);
    break;
  default:
    break;
  }
}

Expected<void> Renderer::light(Film &film, unsigned sample, const std::vector<Hit> &hits) const {
  const LightRays rays(tracers_.occlusion, sun_, spacing_, openScale_, samples_);
  const MetSurfaces met{hits, surfaces_};
  if (options_.style == Style::Lit)
    VOXC_TRY(rays.addSun(film, met, traceOptions()));
  return rays.addSky(film, sample, met, traceOptions());
}

/// Writes the light of some rows of a band into the result.
Expected<void> Renderer::develop(const Film &film, int first, int rows) {
  return forRows(rows, [&](int offset) {
    const int row = first + offset;
    const std::vector<float> sky = kind_.isLit ? skyShares(film, row, isSkySpread(samples_))
                                               : std::vector<float>(std::size_t(film.width));
    for (int column = 0; column < film.width; ++column) {
      const FilmPixel &pixel = film.pixels[film.index(column, row)];
      const glm::vec3 light = (pixel.light + pixel.skyLit * sky[std::size_t(column)]) / float(samples_);
      const std::size_t place = std::size_t(row) * std::size_t(film.width) + std::size_t(column);
      float *const out = &result_.light[4 * place];
      out[0] =
          isMap() ? pixel.value / (options_.style == Style::Depth ? pixel.hits : float(samples_)) : light.x;
      out[1] = light.y;
      out[2] = light.z;
      out[3] = pixel.hits / float(samples_);
      backdrop_[place] = pixel.backdrop / float(samples_);
    }
  });
}

void Renderer::finishDistances() {
  if (distances_.empty())
    return;
  result_.nearest = *std::ranges::min_element(distances_);
  const auto middle = distances_.begin() + std::ptrdiff_t(distances_.size() / 2);
  std::ranges::nth_element(distances_, middle);
  result_.middle = *middle;
}

Expected<void> Renderer::finishMap() {
  std::vector<float> values(backdrop_.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = result_.light[4 * i];
  result_.picture =
      mapPicture(values, camera_.width, camera_.height, kind_.unit, options_.style == Style::Depth);
  return {};
}

/// The colour of what covers a share of a pixel, in what light it was found, times that share.
glm::vec3 Renderer::exposed(const glm::vec3 &light, float share) const {
  if (share <= 0)
    return light;
  if (options_.style == Style::Lit)
    return compress(light * (result_.exposure / share)) * share;
  if (options_.style == Style::Ambient)
    return glm::vec3(clayOf(light.x * result_.exposure / share) * share);
  return light;
}

Expected<void> Renderer::finish() {
  if (options_.style == Style::Lit)
    result_.exposure = exposureOf(result_.light);
  if (options_.style == Style::Ambient)
    result_.exposure = skyExposureOf(result_.light);
  result_.picture = {camera_.width, camera_.height, std::vector<std::uint32_t>(backdrop_.size())};
  return forRows(camera_.height, [&](int row) {
    const std::size_t first = std::size_t(row) * std::size_t(camera_.width);
    for (std::size_t i = first; i < first + std::size_t(camera_.width); ++i) {
      const float *const light = &result_.light[4 * i];
      const glm::vec3 colour = exposed({light[0], light[1], light[2]}, light[3]);
      result_.picture.pixels[i] = screenPixel(colour + backdrop_[i]);
    }
  });
}

Expected<Rendering> Renderer::run() {
  const std::size_t pixels = std::size_t(camera_.width) * std::size_t(camera_.height);
  result_.light.resize(4 * pixels);
  backdrop_.resize(pixels);
  const int bandRows =
      int(std::clamp<std::int64_t>(kBandRays / camera_.width, 4 * kFilmMargin, camera_.height));
  for (int row = 0; row < camera_.height; row += bandRows) {
    const int rows = std::min(bandRows, camera_.height - row);
    const int margin = kind_.isLit && isSkySpread(samples_) ? kFilmMargin : 0;
    const int top = std::max(row - margin, 0);
    const int bottom = std::min(row + rows + margin, camera_.height);
    Film film(camera_.width, top, bottom - top);
    for (unsigned sample = 0; sample < samples_; ++sample) {
      const double done = (row + double(rows) * sample / samples_) / camera_.height;
      options_.progress.at("render", done);
      VOXC_TRY(expose(film, sample));
    }
    VOXC_TRY(develop(film, row, rows));
  }
  finishDistances();
  VOXC_TRY(isMap() ? finishMap() : finish());
  return std::move(result_);
}

} // namespace

Expected<Rendering> render(const Volume &volume, const Camera &camera, const RenderTracers &tracers,
                           const RenderOptions &options) {
  return Renderer(volume, camera, tracers, options).run();
}

bool isSmoothSurface(const VolumeInfo &info) {
  constexpr std::string_view kBlocky[] = {"coverage=models", "coverage=indices"};
  const std::string_view made = info.provenance;
  return made.find("coverage=") != std::string_view::npos &&
         std::ranges::none_of(
             kBlocky, [made](std::string_view word) { return made.find(word) != std::string_view::npos; });
}

} // namespace voxc
