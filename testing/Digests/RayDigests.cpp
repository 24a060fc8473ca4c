// Cameras' rays, hard rays, and the exact hits of those.
#include "testing/Digests/Digest.h"
#include "testing/HardRays.h"
#include "testing/HardScenes.h"

#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/Camera.h"

#include <algorithm>

namespace voxc::test {

namespace {

constexpr Int3 kExtent{48, 33, 64};
constexpr std::size_t kVoxelsAimedAt = 4096;
constexpr std::uint64_t kRaysAtOnce = std::uint64_t{1} << 18;

} // namespace

Expected<void> addCameraDigests(std::vector<NamedDigest> &digests) {
  Checksum checksum;
  const auto add = [&](const Camera &camera) {
    const std::vector<Ray> rays = cameraRays(camera);
    checksum.add(rays.data(), rays.size() * sizeof(Ray));
  };
  for (int step = 0; step < 60; ++step) {
    const glm::dvec3 place(step * 3.7 - 50, 100.1 - step, 0.3 * step);
    Camera camera = cameraFromAngles(kExtent, place, step * 2.9 - 80, step * 7.3, 20 + step, 97, 61,
                                     glm::dvec3(1, 1 + step % 3 * 0.7, 1));
    add(camera);
    add(projected(camera, true));
  }
  add(frameExtent(kExtent, 320, 200));
  digests.push_back({"rays of cameras", checksum.digest()});
  return {};
}

Expected<void> addRayDigests(std::uint64_t rays, std::vector<NamedDigest> &digests) {
  const std::span<const HardRayClass> classes = hardRayClasses();
  const std::vector<HardScene> scenes = hardScenes(kExtent);
  const std::uint64_t each = std::max<std::uint64_t>(1, rays / (classes.size() * scenes.size()));
  std::vector<Checksum> ofRays(classes.size()), ofHits(classes.size());
  for (std::size_t number = 0; number < scenes.size(); ++number) {
    const Expected<Oracle> oracle = Oracle::of(*scenes[number].source());
    if (!oracle)
      return oracle.error();
    const std::vector<Int3> voxels = oracle->sampleVoxels(kVoxelsAimedAt);
    for (std::size_t kind = 0; kind < classes.size(); ++kind)
      for (std::uint64_t done = 0; done < each; done += kRaysAtOnce) {
        const auto some = static_cast<std::size_t>(std::min(kRaysAtOnce, each - done));
        const std::vector<Ray> made = hardRays({kExtent, voxels}, classes[kind].name, some, number + done);
        const Expected<std::vector<Hit>> hits = oracle->trace(made);
        if (!hits)
          return hits.error();
        ofRays[kind].add(made.data(), made.size() * sizeof(Ray));
        ofHits[kind].add(hits->data(), hits->size() * sizeof(Hit));
      }
  }
  for (std::size_t kind = 0; kind < classes.size(); ++kind) {
    const std::string name(classes[kind].name);
    digests.push_back({"hard rays: " + name, ofRays[kind].digest()});
    digests.push_back({"exact hits: " + name, ofHits[kind].digest()});
  }
  return {};
}

} // namespace voxc::test
