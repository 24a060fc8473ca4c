// A robot in hills of voxels: it digs where it looks, builds a tower behind itself, shoots holes into the
// hills, and takes its last shots back. Every frame is edited, brought to the device and shown; at the end
// the hits are held against those of a world that is built anew.
//
// Usage: sandbox [DEVICE [FRAMES [FOLDER]]]. With a folder every tenth frame is written there, as
// frame-N.ppm.
#include "World.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

constexpr int kWidth = 320, kHeight = 180;

int fail(const voxc::Error &error) {
  std::fprintf(stderr, "sandbox: %s\n", error.message.c_str());
  return 1;
}

// Goes around above the hills and looks down at them.
voxc::Camera cameraAt(int frame) {
  const double angle = 0.02 * frame;
  voxc::Camera camera;
  camera.eye = {128 + 110 * std::cos(angle), 90, 128 + 110 * std::sin(angle)};
  camera.look = {128, 30, 128};
  camera.width = kWidth;
  camera.height = kHeight;
  return camera;
}

// From the camera's eye to somewhere near to where it looks.
voxc::Ray aim(const voxc::Camera &camera, std::mt19937 &random) {
  std::uniform_real_distribution<double> spread(-60, 60);
  const glm::dvec3 target = camera.look + glm::dvec3(spread(random), 0, spread(random));
  return voxc::makeRay(glm::vec3(camera.eye), glm::vec3(target - camera.eye));
}

voxc::Int3 voxelOf(const voxc::Hit &hit) { return {hit.voxel[0], hit.voxel[1], hit.voxel[2]}; }

// What the robot does in one frame. Error: that of an edit.
voxc::Expected<void> play(World &world, int frame, const voxc::Camera &camera, std::mt19937 &random) {
  if (const auto dug = world.shoot(aim(camera, random)))
    if (auto edited = world.edit(*voxc::makeSphereChange(voxelOf(*dug), 6, 0)); !edited)
      return edited;
  const voxc::Int3 tower = {120 + frame % 16, 20 + frame / 4, 120 + frame / 16 % 16};
  if (auto edited = world.edit(*voxc::makeBoxChange(tower, {1, 4, 1}, voxc::rgba(200, 60, 40))); !edited)
    return edited;
  const auto before = world.save();
  for (int shot = 0; shot < 4; ++shot)
    if (const auto hit = world.shoot(aim(camera, random)))
      if (auto edited = world.edit(*voxc::makeSphereChange(voxelOf(*hit), 2, 0)); !edited)
        return edited;
  if (frame % 5 == 4) // The last shots missed, after all.
    world.load(before);
  return {};
}

bool write(const voxc::Picture &picture, const std::string &path) {
  std::FILE *const file = std::fopen(path.c_str(), "wb");
  if (!file)
    return false;
  std::fprintf(file, "P6\n%d %d\n255\n", picture.width, picture.height);
  for (const std::uint32_t pixel : picture.pixels)
    for (const int shift : {0, 8, 16})
      std::fputc(int(pixel >> shift & 255), file);
  return std::fclose(file) == 0;
}

} // namespace

int main(int argc, char **argv) {
  const int frames = argc > 2 ? std::atoi(argv[2]) : 100;
  auto world = World::create(argc > 1 ? argv[1] : "");
  if (!world)
    return fail(world.error());
  std::mt19937 random(1);
  FrameCosts all;
  std::uint64_t mostCopied = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const voxc::Camera camera = cameraAt(frame);
    if (auto played = play(*world, frame, camera, random); !played)
      return fail(played.error());
    const auto picture = world->show(camera);
    if (!picture)
      return fail(picture.error());
    if (argc > 3 && frame % 10 == 0 &&
        !write(*picture, std::string(argv[3]) + "/frame-" + std::to_string(frame) + ".ppm"))
      return fail(voxc::Error::environment("the folder cannot be written to"));
    const FrameCosts costs = world->takeCosts();
    all.edits += costs.edits;
    all.editSeconds += costs.editSeconds;
    all.followSeconds += costs.followSeconds;
    all.traceSeconds += costs.traceSeconds;
    mostCopied = std::max(mostCopied, costs.copiedBytes);
  }
  std::printf("%d edits in %d frames: %.1f us an edit, %.3f ms a frame to bring them to the device, %.1f ms "
              "a picture\n",
              all.edits, frames, 1e6 * all.editSeconds / std::max(all.edits, 1),
              1e3 * all.followSeconds / frames, 1e3 * all.traceSeconds / frames);
  std::printf("at most %llu bytes a frame were copied; %llu voxels in %llu words\n",
              static_cast<unsigned long long>(mostCopied), static_cast<unsigned long long>(world->voxels()),
              static_cast<unsigned long long>(world->words()));
  std::vector<voxc::Ray> rays;
  for (int i = 0; i < 20000; ++i)
    rays.push_back(aim(cameraAt(i % 300), random));
  const auto wrong = world->wrongHits(rays);
  if (!wrong)
    return fail(wrong.error());
  std::printf("%d of %zu rays hit otherwise than in a world that is built anew\n", *wrong, rays.size());
  return *wrong == 0 ? 0 : 1;
}
