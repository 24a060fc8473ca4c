// A volume, placed in a world a hundred thousand times: what a ray costs among so many.
//
// Usage: instances VOLUME.hvx [DEVICE [MOST]]. Prints a row for each number of instances up to MOST: rays a
// second by CPU time of the process, and how many times as long a ray takes as with one instance.
#include <voxc/Kernel/OpenTracer.h>
#include <voxc/Trace/InstancedTracer.h>

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr int kRounds = 9;

// Places on a square grid, a volume's diagonal apart, each turned about its upright axis and a little higher
// or lower than its neighbours.
std::vector<glm::mat4> field(int count, const glm::vec3 &size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(0, 1);
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  const float pitch = 1.1f * glm::length(glm::vec2(size.x, size.y));
  std::vector<glm::mat4> places;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at(static_cast<float>(i % side) * pitch, static_cast<float>(i / side) * pitch, // NOLINT
                       number(random) * size.z / 4);
    const glm::mat4 turned =
        glm::rotate(glm::translate(glm::mat4(1), at), 6.2832f * number(random), glm::vec3(0, 0, 1));
    places.push_back(glm::translate(turned, size * -0.5f));
  }
  return places;
}

// Rays of a camera that looks down on a field from one of its corners.
std::vector<voxc::Ray> look(const std::vector<glm::mat4> &places, const glm::vec3 &size) {
  glm::vec3 low(1e30f), high(-1e30f);
  for (const glm::mat4 &place : places) {
    const glm::vec3 middle(place * glm::vec4(size * 0.5f, 1));
    low = glm::min(low, middle - size * 0.5f);
    high = glm::max(high, middle + size * 0.5f);
  }
  const glm::vec3 middle = (low + high) * 0.5f;
  const glm::vec3 eye = middle + glm::length(high - low) * glm::vec3(-0.45f, -0.35f, 0.3f);
  const glm::vec3 forward = glm::normalize(middle - eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 0, 1)));
  const glm::vec3 up = glm::cross(right, forward);
  std::vector<voxc::Ray> rays;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float across = 0.8f * ((static_cast<float>(x) + 0.5f) / kHeight - 0.5f * kWidth / kHeight);
      const float down = 0.8f * ((static_cast<float>(y) + 0.5f) / kHeight - 0.5f);
      rays.push_back(voxc::makeRay(eye, forward + across * right - down * up));
    }
  return rays;
}

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// What is traced for one row, and how long it takes.
struct Row {
  std::vector<voxc::Ray> rays;
  std::vector<voxc::InstanceHit> hits;
  std::unique_ptr<voxc::InstancedTracer> world;
  std::vector<double> seconds;

  bool trace() {
    const double before = cpuSeconds();
    const auto traced = world->trace(rays, hits);
    seconds.push_back(cpuSeconds() - before);
    if (!traced)
      std::fprintf(stderr, "instances: %s\n", traced.error().message.c_str());
    return bool(traced);
  }
  double median() {
    std::ranges::nth_element(seconds, seconds.begin() + kRounds / 2);
    return seconds[kRounds / 2];
  }
};

int fail(const voxc::Error &error) {
  std::fprintf(stderr, "instances: %s\n", error.message.c_str());
  return 1;
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: instances VOLUME.hvx [DEVICE [MOST]]\n");
    return 2;
  }
  auto volume = voxc::Volume::load(argv[1]);
  if (!volume)
    return fail(volume.error());
  // Rays that end at the nearest hit so far: a kernel with bounds.
  voxc::Format format = volume->format();
  format.setAttribute(voxc::kBoundsAttribute, "yes");
  auto tracer = voxc::openTracer(*volume, {.device = argc > 2 ? argv[2] : "cpu", .format = format});
  if (!tracer)
    return fail(tracer.error());
  const voxc::Int3 extent = volume->format().extent();
  const glm::vec3 size(extent.x, extent.y, extent.z);
  const int most = argc > 3 ? std::atoi(argv[3]) : 100000;
  std::vector<Row> rows;
  for (int count = 1; count <= most; count *= 10) {
    std::vector<voxc::Instance> instances;
    for (const glm::mat4 &place : field(count, size))
      instances.push_back({(*tracer).get(), extent, place, true});
    auto world = voxc::InstancedTracer::create(instances);
    if (!world)
      return fail(world.error());
    Row row;
    row.rays = look(field(count, size), size);
    row.hits.resize(row.rays.size());
    row.world = std::make_unique<voxc::InstancedTracer>(std::move(*world));
    rows.push_back(std::move(row));
  }
  // In turn, so that what else the machine does meets all alike; the first round warms up.
  for (int round = 0; round <= kRounds; ++round)
    for (Row &row : rows) {
      if (round == 1)
        row.seconds.clear();
      if (!row.trace())
        return 1;
    }
  std::printf("%9s  %8s  %10s  %6s\n", "instances", "hits", "M rays/s", "times");
  for (std::size_t i = 0, count = 1; i < rows.size(); ++i, count *= 10)
    std::printf("%9zu  %8td  %10.2f  %6.2f\n", count,
                std::ranges::count_if(rows[i].hits, &voxc::InstanceHit::isHit),
                static_cast<double>(rows[i].rays.size()) / rows[i].median() / 1e6,
                rows[i].median() / rows[0].median());
  return 0;
}
