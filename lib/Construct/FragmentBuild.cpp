// Building and joining fragments.
#include "Construct/Fragments/FragmentSet.h"
#include "Construct/Fragments/JoinedParts.h"
#include "Construct/Host/SourceHost.h"
#include "Construct/Parts/ParallelParts.h"
#include "ConstructorState.h"

#include "Source/CubeTools.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc {

/// Fragments are built of parts up to 2^this times as large as the smallest: words that a part has twice are
/// written once, and what a part takes in memory stays little.
constexpr int kLog2LargerPart = 2;

/// Parts of a fragment are joined to one as long as they take no more than this share of the memory.
constexpr std::uint64_t kPartsInMemory = 8;

Expected<BuildReport> Constructor::buildFragment(VoxelSource &source, std::uint64_t index,
                                                 std::uint64_t count, const std::string &path,
                                                 const BuildOptions &options) const {
  const auto [begin, end] = PartGrid::of(source, state_->layout()).range(index, count);
  return buildFragment(source, FragmentShare{index, count, begin, end}, path, options);
}

Expected<BuildReport> Constructor::buildFragment(VoxelSource &exact, const FragmentShare &share,
                                                 const std::string &path, const BuildOptions &given) const {
  const Stopwatch watch;
  const BuildOptions options = withMemory(given);
  const Format &format = state_->format();
  const Layout &layout = state_->layout();
  const auto rounded = roundedAs(layout, exact);
  VoxelSource &source = rounded ? *rounded : exact;
  VOXC_TRY(checkFits(source.extent(), format));
  const PartGrid smallest = PartGrid::of(source, layout);
  const PartGrid grid = smallest.upTo(smallest.log2Side + kLog2LargerPart, layout);
  auto writer =
      VOXC_TRY(FragmentWriter::create(path, {infoOf(source, format, options), grid.log2Side, share}));
  auto parts =
      VOXC_TRY(ParallelParts::start(source, state_->functions(), layout, grid, share.begin, share.end,
                                    std::max(options.threads, 1u), options.memory, options.progress));
  BuildReport report;
  MortonProgress progress(source.extent(), options.progress);
  for (auto cube = parts->next(); !cube.isEnd(); cube = parts->next()) {
    if (cube.failed())
      return cube.error();
    auto fragment = VOXC_TRY(parts->take());
    VOXC_TRY(writer.add(fragment));
    report.voxels += fragment.voxels;
    if (!progress.at(cube->low, report.voxels))
      return Error::interrupted();
  }
  VOXC_TRY(writer.finish(parts->looked()));
  if (rounded)
    report.colourError = rounded->error();
  report.readSeconds = source.readSeconds();
  report.scratchBytes = options.memory->scratchPeak();
  report.seconds = watch.seconds();
  report.cpuSeconds = watch.cpuSeconds();
  return report;
}

namespace {

/// Is it known that no part is left in a cube? Who takes one where the fragments are broken is told so.
bool hasNone(const Cube &cube, FragmentSet &fragments) {
  const auto next = fragments.next();
  return !next.failed() &&
         (next.isEnd() || mortonCode(next->low) - mortonCode(cube.low) >= cellCount(cube.log2Side));
}

/// Is the next part smaller than a cube that it lies in, and are all parts there more than `mostBytes`?
bool isTooLarge(const Cube &cube, FragmentSet &fragments, std::uint64_t mostBytes) {
  const auto next = fragments.next();
  return !next.failed() && !next.isEnd() && next->log2Side < cube.log2Side &&
         fragments.bytesIn(cube) > mostBytes;
}

} // namespace

Expected<BuildReport> Constructor::joinFragments(const std::vector<std::string> &paths,
                                                 const FragmentShare &share, const std::string &path,
                                                 const BuildOptions &given) const {
  const Stopwatch watch;
  const BuildOptions options = withMemory(given);
  auto fragments = VOXC_TRY(FragmentSet::openRun(paths, options.memory));
  VOXC_TRY(checkFormat(fragments));
  const FragmentInfo &info = fragments.info();
  if (fragments.cubes() != std::pair(share.begin, share.end))
    return Error::input("the fragments have other cubes than the one that they are to be joined to: " +
                        std::to_string(fragments.cubes().first) + " to " +
                        std::to_string(fragments.cubes().second) + ", not " + std::to_string(share.begin) +
                        " to " + std::to_string(share.end));
  auto writer = VOXC_TRY(FragmentWriter::create(path, {info.volume, info.log2Side, share}));
  auto joined = VOXC_TRY(JoinedParts::create(fragments, state_->functions(), options.memory));
  const std::uint64_t mostBytes = options.memory->bound() / kPartsInMemory;
  const Layout &layout = state_->layout();
  PartSequence cubes(
      PartGrid::of(info.volume.extent, layout, info.log2Side).upTo(kMaxLog2Extent, layout), share.begin,
      share.end, [&](const Cube &cube) { return hasNone(cube, fragments); },
      [&](const Cube &cube) { return isTooLarge(cube, fragments, mostBytes); });
  BuildReport report;
  while (const auto cube = cubes.next()) {
    VOXC_TRY(options.progress.check());
    auto fragment = VOXC_TRY(joined.join(*cube, options.progress));
    VOXC_TRY(writer.add(fragment));
    report.voxels += fragment.voxels;
  }
  if (const auto left = fragments.next(); left.failed())
    return left.error();
  else if (!left.isEnd())
    return Error::input("a part lies outside the share of the volume that is merged");
  VOXC_TRY(writer.finish(cubes.looked()));
  report.scratchBytes = options.memory->scratchPeak();
  report.seconds = watch.seconds();
  report.cpuSeconds = watch.cpuSeconds();
  return report;
}

Expected<FragmentShare> checkFragment(const std::string &path) {
  auto reader = VOXC_TRY(FragmentReader::open(path));
  return reader.info().share;
}

Expected<Format> formatOfFragment(const std::string &path) {
  auto reader = VOXC_TRY(FragmentReader::open(path));
  return reader.info().volume.format;
}

} // namespace voxc
