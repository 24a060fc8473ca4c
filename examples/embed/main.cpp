// Embedding voxc: a voxel source of one's own is built in a format of one's choice, and a ray is traced
// through it.
#include <voxc/Construct/Constructor.h>
#include <voxc/Kernel/OpenTracer.h>

#include <array>
#include <cstdio>

namespace {

// A ball in the middle of 64^3 voxels, coloured by position.
class Ball final : public voxc::VoxelSource {
public:
  voxc::Int3 extent() const override { return {kSide, kSide, kSide}; }

  // A cube is empty if even its point nearest to the centre lies outside the ball.
  bool empty(const voxc::Cube &cube) override {
    const auto gap = [&](int low) {
      const int high = low + int(cube.side()) - 1;
      return kCentre < low ? low - kCentre : kCentre > high ? kCentre - high : 0;
    };
    return !inside(gap(cube.low.x), gap(cube.low.y), gap(cube.low.z));
  }

  voxc::Expected<void> read(const voxc::Cube &cube, std::uint32_t *words) override {
    for (std::uint64_t i = 0; i < std::uint64_t{1} << (3 * cube.log2Side); ++i) {
      const voxc::Int3 cell = cube.low + voxc::mortonCell(i);
      const bool full = inside(cell.x - kCentre, cell.y - kCentre, cell.z - kCentre);
      words[i] = full ? voxc::rgba(4 * cell.x, 4 * cell.y, 4 * cell.z) : 0;
    }
    return {};
  }

private:
  static constexpr int kSide = 64, kCentre = 32, kRadius = 24;

  static bool inside(int x, int y, int z) { return x * x + y * y + z * z <= kRadius * kRadius; }
};

int fail(const voxc::Error &error) {
  std::fprintf(stderr, "embed: %s\n", error.message.c_str());
  return 1;
}

} // namespace

int main() {
  voxc::Expected<voxc::Format> format = voxc::parseFormat("R(2, 2, 2) G(4)");
  if (!format)
    return fail(format.error());

  voxc::Expected<voxc::Constructor> constructor = voxc::Constructor::compile(*format);
  if (!constructor)
    return fail(constructor.error());
  Ball ball;
  voxc::Expected<voxc::Built> built = constructor->build(ball);
  if (!built)
    return fail(built.error());

  auto tracer = voxc::openTracer(built->volume);
  if (!tracer)
    return fail(tracer.error());

  const std::array rays{voxc::Ray{{-10.0f, 32.5f, 32.5f}, {1.0f, 0.0f, 0.0f}},
                        voxc::Ray{{-10.0f, 1.5f, 32.5f}, {1.0f, 0.0f, 0.0f}}};
  std::array<voxc::Hit, rays.size()> hits;
  if (auto traced = (*tracer)->trace(rays, hits); !traced)
    return fail(traced.error());

  std::printf("%llu voxels in %zu words\n", static_cast<unsigned long long>(built->report.voxels),
              built->volume.words().size());
  for (const voxc::Hit &hit : hits)
    if (hit.isHit())
      std::printf("hit (%d, %d, %d) at t = %g\n", hit.voxel[0], hit.voxel[1], hit.voxel[2], double(hit.t));
    else
      std::printf("miss\n");
}
