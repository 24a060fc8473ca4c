// Tracers by hand on a device.
#include "PeerSubject.h"

#include "Difference.h"

#include <algorithm>
#include <array>

namespace voxc::gpu {
namespace {

constexpr std::size_t kHead = 4;
constexpr std::uint32_t kTile = 8; // Columns and rows of a workgroup.
constexpr std::uint32_t kMiss = ~std::uint32_t{0};

struct Nodes {
  std::uint32_t edge, levels;
  std::span<const std::uint32_t> a, b;
};

Expected<Nodes> parse(std::span<const std::uint32_t> words) {
  const std::uint64_t a = words.size() < kHead ? 0 : std::uint64_t{words[2]} * 3;
  if (words.size() < kHead || words.size() < kHead + a + words[3])
    return Error::input("the nodes of a peer are cut short");
  return Nodes{words[0], words[1], words.subspan(kHead, a), words.subspan(kHead + a, words[3])};
}

Expected<GpuBuffer> bring(const Gpu &gpu, std::span<const std::uint32_t> words) {
  auto buffer = VOXC_TRY(gpu.makeBuffer(words.size_bytes()));
  VOXC_TRY(gpu.upload(buffer, std::as_bytes(words)));
  return buffer;
}

Difference compare(std::span<const std::array<std::uint32_t, 2>> hits, std::span<const Hit> exact) {
  Difference all;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::uint32_t voxel = hits[i][0];
    const auto axis = [&](int shift) { return static_cast<std::int32_t>(voxel >> shift & 1023); };
    const std::array at = {axis(0), axis(10), axis(20)};
    if ((voxel != kMiss) != exact[i].isHit())
      ++(exact[i].isHit() ? all.missed : all.ghost);
    else if (voxel != kMiss && !std::ranges::equal(at, exact[i].voxel))
      ++all.wrong;
  }
  return all;
}

} // namespace

Expected<tool::Json> measurePeer(const Gpu &gpu, std::span<const std::uint32_t> spirv,
                                 std::span<const std::uint32_t> words, std::span<const RaysThere> sets,
                                 double seconds) {
  const auto nodes = VOXC_TRY(parse(words));
  const auto a = VOXC_TRY(bring(gpu, nodes.a));
  const auto b = VOXC_TRY(bring(gpu, nodes.b));
  const auto program = VOXC_TRY(Program::make(gpu, spirv, 4, 4));
  tool::Json rows = tool::Json::array();
  for (const RaysThere &set : sets) {
    program.bind(std::array{&a, &b, &set.buffer, &set.hits});
    const auto count = static_cast<std::uint32_t>(set.rays.size());
    const std::uint32_t pixelRows = (count + kPeerColumns - 1) / kPeerColumns;
    const GpuStep step{.program = &program,
                       .words = {kPeerColumns, pixelRows, nodes.edge, nodes.levels},
                       .groupsX = (kPeerColumns + kTile - 1) / kTile,
                       .groupsY = (pixelRows + kTile - 1) / kTile};
    const auto times = VOXC_TRY(timeSteps(gpu, std::span(&step, 1), seconds));
    std::vector<std::array<std::uint32_t, 2>> hits(set.rays.size());
    VOXC_TRY(gpu.download(set.hits, std::as_writable_bytes(std::span(hits))));
    rows.push_back({{"rays", set.name},
                    {"count", set.rays.size()},
                    {"mrays_per_s", speedJson(set.rays.size(), times)},
                    {"error", compare(hits, set.exact).toJson()}});
  }
  return tool::Json{{"programs", tool::Json::array({figuresJson(program)})},
                    {"rows", rows},
                    {"bytes", (nodes.a.size() + nodes.b.size()) * sizeof(std::uint32_t)}};
}

} // namespace voxc::gpu
