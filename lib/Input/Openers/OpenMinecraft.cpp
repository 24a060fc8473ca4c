// Opening Minecraft's schematics: blocks as voxels, each of one colour. Their up is +y, as that of voxels.
#include "Input/Openers/Openers.h"

#include "Input/Dense/GzipReader.h"
#include "Input/Minecraft/BlockScene.h"
#include "Input/Openers/InputText.h"
#include "Source/BinnedVoxels.h"
#include "Source/GridExtent.h"
#include "Support/Text.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <utility>

namespace voxc {

namespace {

using BlockBox = std::array<std::int64_t, 3>;

/// The bytes that gzip packed, `packed` becoming those behind. How many there are nobody says before.
Expected<InflatedBytes> inflate(std::span<const std::byte> &packed, const InputOptions &options) {
  constexpr std::uint64_t kStep = std::uint64_t{1} << 20;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
  GzipReader reader(packed);
  InflatedBytes bytes(options.memory);
  for (std::uint64_t done = 0;;) {
    VOXC_TRY(options.progress.check());
    if (done >= kMost)
      return Error::input("it has more than 4 GiB when it is inflated");
    VOXC_TRY(bytes.resize(done + kStep));
    const auto read = VOXC_TRY(reader.readSome(bytes.span().subspan(done, kStep)));
    done += read;
    options.memory->relieve(kStep);
    if (read == kStep)
      continue;
    VOXC_TRY(bytes.resize(done));
    packed = reader.behind();
    return bytes;
  }
}

/// The box around all regions.
struct Around {
  BlockBox low, high;

  explicit Around(const std::vector<BlockRegion> &regions) : low(regions.front().low), high(low) {
    for (const BlockRegion &region : regions)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], region.low[axis]);
        high[axis] = std::max(high[axis], region.low[axis] + region.size[axis]);
      }
  }
};

/// Calls `visit(voxel, word)` for each block of each region. Later regions do not cover earlier ones.
template <typename Visit>
Expected<void> forEachBlock(const BlockScene &scene, const BlockBox &low, const InputOptions &options,
                            Visit visit) {
  for (const BlockRegion &region : scene.regions) {
    auto visited = region.forEachBlock(options.progress, [&](const BlockBox &cell, std::uint32_t word) {
      const auto along = [&](std::size_t axis) {
        return static_cast<std::int32_t>(region.low[axis] - low[axis] + cell[axis]);
      };
      visit(Int3{along(0), along(1), along(2)}, word);
    });
    if (!visited)
      return visited;
  }
  return {};
}

Expected<Input> openScene(BlockScene scene, const InputOptions &options) {
  const Around box(scene.regions);
  const Int3 holds = options.mostExtent();
  BlockBox size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    size[axis] = box.high[axis] - box.low[axis];
  if (size[0] > holds.x || size[1] > holds.y || size[2] > holds.z)
    return Error::usage("takes " + std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" +
                        std::to_string(size[2]) + " voxels, but the format holds " + extentText(holds) +
                        "; enlarge the format");
  const Int3 extent{static_cast<std::int32_t>(size[0]), static_cast<std::int32_t>(size[1]),
                    static_cast<std::int32_t>(size[2])};
  auto voxels = VOXC_TRY(BinnedVoxels::create(extent, options.memory));
  std::uint64_t blocks = 0;
  auto counted = forEachBlock(scene, box.low, options, [&](Int3 voxel, std::uint32_t) {
    voxels.count(voxel);
    ++blocks;
  });
  if (!counted)
    return counted.error();
  VOXC_TRY(voxels.allocate());
  auto placed = forEachBlock(scene, box.low, options,
                             [&](Int3 voxel, std::uint32_t word) { voxels.place(voxel, word); });
  if (!placed)
    return placed.error();
  Input input;
  Transform map;
  for (int axis = 0; axis < 3; ++axis)
    map[3][axis] = static_cast<double>(box.low[static_cast<std::size_t>(axis)]);
  input.source = std::move(voxels).finish(map);
  input.provenance = "coverage=blocks";
  input.warnings = std::move(scene.warnings);
  if (options.describe)
    input.facts = {countFact("regions", scene.regions.size()), sizeFact("size", extent),
                   countFact("blocks", blocks)};
  return input;
}

Expected<Input> openBytes(std::span<const std::byte> bytes, const InputOptions &options) {
  InflatedBytes inflated(options.memory);
  std::uint64_t behind = 0;
  if (isGzip(bytes)) {
    auto all = VOXC_TRY(inflate(bytes, options));
    behind = bytes.size();
    inflated = std::move(all);
    bytes = std::as_const(inflated).span();
  }
  const auto tags = VOXC_TRY(readNbt(bytes));
  const std::span<const std::byte> payload = tags.payload();
  behind += bytes.size() - static_cast<std::size_t>(payload.data() + payload.size() - bytes.data());
  auto scene = VOXC_TRY(readBlockScene(tags, options.progress));
  if (behind != 0)
    scene.warnings.push_back(countedAre(behind, "byte") + " left out behind the end of its tags");
  return openScene(std::move(scene), options);
}

} // namespace

Expected<Input> openMinecraft(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  const auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  auto opened = openBytes(file->bytes(), options);
  if (!opened && opened.error().kind == ErrorKind::Usage)
    return Error::usage("'" + path + "' " + opened.error().message);
  auto input = VOXC_TRY(usable(std::move(opened), path, "Minecraft schematic"));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
