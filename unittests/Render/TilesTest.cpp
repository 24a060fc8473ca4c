// Pictures are traced tile by tile, and are what rays in rows make.
#include "Render/Tiles.h"

#include "Render/Exposure.h"
#include "Render/Film.h"
#include "Render/Lighting.h"
#include "Render/Surface.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Render/Render.h"
#include "voxc/Trace/PixelRays.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace voxc {
namespace {

struct Size {
  int width, rows;
};
constexpr Size kSizes[] = {{1, 1},   {16, 16}, {32, 48}, {5, 40}, {40, 5},
                           {17, 33}, {31, 15}, {1, 50},  {50, 1}};

template <TileOrder kOrder> std::vector<TiledPixel> pixelsOf(Size size) {
  std::vector<TiledPixel> pixels;
  Tiles(size.width, size.rows).visitAll<kOrder>([&](const TiledPixel &at) { pixels.push_back(at); });
  return pixels;
}

TEST(Tiles, HoldEachPixelOnce) {
  for (const Size size : kSizes) {
    const std::vector<TiledPixel> near = pixelsOf<TileOrder::Near>(size);
    const std::size_t count = std::size_t(size.width) * std::size_t(size.rows);
    ASSERT_EQ(near.size(), count);
    std::set<std::uint32_t> pixels;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(near[i].ray, i);
      EXPECT_EQ(near[i].pixel, std::uint32_t(near[i].row * size.width + near[i].column));
      EXPECT_LT(near[i].pixel, count);
      pixels.insert(near[i].pixel);
    }
    EXPECT_EQ(pixels.size(), count);
  }
}

TEST(Tiles, NumberPixelsAlikeInBothOrders) {
  for (const Size size : kSizes) {
    const std::vector<TiledPixel> near = pixelsOf<TileOrder::Near>(size);
    std::vector<TiledPixel> alike = pixelsOf<TileOrder::Alike>(size);
    std::ranges::sort(alike, {}, &TiledPixel::ray);
    ASSERT_EQ(alike.size(), near.size());
    for (std::size_t i = 0; i < near.size(); ++i)
      EXPECT_EQ(alike[i].pixel, near[i].pixel);
  }
}

TEST(Tiles, KeepNeighboursTogether) {
  constexpr int kWidth = 64, kPacket = 16;
  const std::vector<TiledPixel> near = pixelsOf<TileOrder::Near>({kWidth, 48});
  const std::vector<TiledPixel> alike = pixelsOf<TileOrder::Alike>({kWidth, 48});
  for (std::size_t first = 0; first < near.size(); first += kPacket)
    for (std::size_t i = first; i < first + kPacket; ++i) {
      EXPECT_EQ(near[i].pixel % kWidth / 4, near[first].pixel % kWidth / 4);
      EXPECT_EQ(near[i].pixel / kWidth / 4, near[first].pixel / kWidth / 4);
      const auto patternOf = [](const TiledPixel &at) {
        return skyPattern(int(at.pixel % kWidth), int(at.pixel / kWidth));
      };
      EXPECT_EQ(patternOf(alike[i]), patternOf(alike[first]));
    }
}

/// A raw grid of 16 voxels a side, its own colour in each voxel.
Volume rockyVolume() {
  constexpr std::uint32_t kSide = 16;
  std::vector<std::uint32_t> words = {1};
  VolumeInfo info;
  info.format = *parseFormat("R(4,4,4)");
  info.extent = {kSide, kSide, kSide};
  for (std::uint32_t i = 0; i < kSide * kSide * kSide; ++i) {
    const bool isFull = (i * 2654435761u >> 28) < 2;
    words.push_back(isFull ? 0xff000000 | (i * 40503u & 0xffffff) : 0);
    info.voxels += isFull;
  }
  return Volume(std::move(info), std::move(words));
}

/// What pictures show, one pixel after the other.
class InRows {
public:
  InRows(const Volume &volume, const Camera &camera, const RenderOptions &options)
      : oracle_(*Oracle::of(volume)), camera_(camera), options_(options),
        sun_(glm::normalize(glm::vec3(options.sun))) {}

  /// The light of a pixel that takes so many samples that it looks at the sky without its neighbours.
  glm::vec3 lit(int column, int row) const {
    glm::vec3 bySun(0), bySky(0);
    float sky = 0, hits = 0;
    for (unsigned sample = 0; sample < options_.samples; ++sample) {
      const Ray ray = PixelRays(camera_, evenNumbers(sample)).through(column, row);
      const Hit hit = oracle_.trace(ray);
      if (!hit.isHit())
        continue;
      const Surface surface = spacedSurface(ray, hit, nullptr, camera_.spacing, nullptr);
      hits += 1;
      bySky += linearColour(hit.rgba) * skyLight(surface.normal);
      const float facing = glm::dot(surface.normal, sun_);
      if (facing > 0 && !oracle_.trace(makeRay(surface.start, sun_)).isHit())
        bySun += linearColour(hit.rgba) * kSunLight * facing;
      const std::uint32_t number = skyPattern(column, row) * options_.samples + sample;
      const glm::vec3 aside = skyDirection(surface.normal, evenNumbers(number));
      sky += openness(oracle_.trace(makeRay(surface.start, aside)), 0.06f * 16);
    }
    return hits > 0 ? (bySun + bySky * (sky / hits)) / float(options_.samples) : glm::vec3(0);
  }

private:
  Oracle oracle_;
  Camera camera_;
  RenderOptions options_;
  glm::vec3 sun_;
};

/// The light of a picture that is traced by the oracle.
Rendering traced(const Volume &volume, const Camera &camera, const RenderOptions &options) {
  const Oracle oracle = *Oracle::of(volume);
  const auto trace = [&](std::span<const Ray> rays, std::span<Hit> hits,
                         const TraceOptions &) -> Expected<void> {
    std::ranges::transform(rays, hits.begin(), [&](const Ray &ray) { return oracle.trace(ray); });
    return {};
  };
  return *render(volume, camera, {trace, trace}, options);
}

TEST(Render, LitPicturesAreThoseOfRaysInRows) {
  const Volume volume = rockyVolume();
  // Several tiles, those at the edges partial; 32 samples of a pixel do not share their sky with others.
  const Camera camera = frameExtent({16, 16, 16}, 37, 18);
  const RenderOptions options{.samples = 32};
  const Rendering picture = traced(volume, camera, options);
  const InRows reference(volume, camera, options);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const glm::vec3 expected = reference.lit(column, row);
      const float *const light = &picture.light[4 * std::size_t(row * camera.width + column)];
      ASSERT_EQ(glm::vec3(light[0], light[1], light[2]), expected) << column << ", " << row;
    }
}

TEST(Render, FacesAndDistancesAreThoseOfRaysInRows) {
  const Volume volume = rockyVolume();
  const Oracle oracle = *Oracle::of(volume);
  for (const Size size : kSizes) {
    const Camera camera = frameExtent({16, 16, 16}, size.width, size.rows);
    const std::vector<Ray> rays = cameraRays(camera);
    const std::vector<Hit> hits = *oracle.trace(rays);
    const Picture shaded = shade(rays, hits, camera.width, camera.height);
    const Rendering faces = traced(volume, camera, {.style = Style::Flat, .samples = 1});
    const Rendering distances = traced(volume, camera, {.style = Style::Depth, .samples = 1});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const float *const light = &faces.light[4 * i];
      ASSERT_EQ(glm::vec3(light[0], light[1], light[2]), linearColour(shaded.pixels[i])) << i;
      if (hits[i].isHit()) {
        ASSERT_EQ(distances.light[4 * i], hits[i].t) << i;
      }
    }
  }
}

} // namespace
} // namespace voxc
