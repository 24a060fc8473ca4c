// Functions for others (`voxc compile --emit=header`), compiled as their users compile them: without any flag
// that keeps floating point as it is written.
#include "testing/Digests/Digest.h"
#include "testing/HardRays.h"
#include "testing/HardScenes.h"

#include "voxc/Oracle/Oracle.h"

#include "voxc_digests.h"

#include <bit>
#include <limits>

namespace voxc::test {

namespace {

constexpr int kSide = 32;

/// The words of a scene in the format of the functions, R(5^3): a root, and one cell after the other.
std::vector<std::uint32_t> wordsOf(const HardScene &scene) {
  std::vector<std::uint32_t> words{1};
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        words.push_back(scene.voxel({x, y, z}));
  return words;
}

bool isSame(const Hit &exact, const voxc_digests_Hit &hit) {
  return exact.voxel[0] == hit.voxel.x && exact.voxel[1] == hit.voxel.y && exact.voxel[2] == hit.voxel.z &&
         std::bit_cast<std::uint32_t>(exact.t) == std::bit_cast<std::uint32_t>(hit.t);
}

} // namespace

Expected<void> addFunctionDigests(std::uint64_t rays, std::vector<NamedDigest> &digests) {
  const std::span<const HardRayClass> classes = hardRayClasses();
  const std::vector<HardScene> scenes = hardScenes({kSide, kSide, kSide});
  const std::uint64_t each = std::max<std::uint64_t>(1, rays / (classes.size() * scenes.size()));
  Checksum checksum;
  for (const HardScene &scene : scenes) {
    const Expected<Oracle> oracle = Oracle::of(*scene.source());
    if (!oracle)
      return oracle.error();
    const std::vector<std::uint32_t> words = wordsOf(scene);
    const std::vector<Int3> voxels = oracle->sampleVoxels(4096);
    for (const HardRayClass &kind : classes)
      for (const Ray &ray : hardRays({scene.extent, voxels}, kind.name, each, 1)) {
        constexpr float kEndless = std::numeric_limits<float>::infinity();
        voxc_digests_Hit hit;
        voxc_digests_closest(words.data(), {ray.origin[0], ray.origin[1], ray.origin[2]},
                             {ray.direction[0], ray.direction[1], ray.direction[2]}, 0, kEndless, hit);
        if (!isSame(oracle->trace(ray), hit))
          return Error::input("a function of a header is wrong about a ray of the class " +
                              std::string(kind.name) + " in the scene " + scene.name);
        checksum.add(&hit.voxel, sizeof hit.voxel);
        checksum.add(&hit.t, sizeof hit.t);
      }
  }
  digests.push_back({"hits of functions", checksum.digest()});
  return {};
}

} // namespace voxc::test
