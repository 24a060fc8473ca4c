// The parts of a finished volume, one after the other.
#include "voxc/Construct/Split.h"

#include "Construct/Fragments/FragmentFile.h"
#include "Construct/Host/SourceHost.h"
#include "Construct/Parts/Extraction.h"
#include "Construct/Parts/PartBuilder.h"

#include "Source/CubeTools.h"
#include "voxc/Support/Stopwatch.h"

namespace voxc {
namespace {

/// Small enough for a part's words to stay in memory, large enough for the parts to be few.
constexpr int kLog2Part = 7;

bool isEmpty(const Fragment &fragment) {
  return fragment.cells.empty() && fragment.node.kind == construct::Node::Empty;
}

} // namespace

Expected<BuildReport> splitVolume(const Volume &volume, std::uint64_t index, std::uint64_t count,
                                  const std::string &path, const Progress &progress) {
  const Stopwatch watch;
  const PartGrid grid = PartGrid::of(volume.info().extent, volume.layout(), kLog2Part);
  const auto [begin, end] = grid.range(index, count);
  auto writer =
      VOXC_TRY(FragmentWriter::create(path, {volume.info(), grid.log2Side, {index, count, begin, end}}));
  Extraction extraction(volume.words(), volume.layout());
  if (!extraction.canTakeOut())
    return Error::usage("parts of a volume with mirror=yes cannot be taken out of it, since its nodes do not "
                        "say which reflections leave them as they are; build the parts from the input");
  BuildReport report;
  MortonProgress steps(volume.info().extent, progress);
  PartSequence parts(grid, begin, end, [&](const Cube &cube) {
    const Lookup found = volume.lookup(cube.low);
    return found.value == 0 && found.log2Side >= cube.log2Side;
  });
  while (const std::optional<Cube> part = parts.next()) {
    if (!steps.at(part->low, report.voxels))
      return Error::interrupted();
    const Fragment fragment = extraction.cube(part->low, part->log2Side);
    if (isEmpty(fragment))
      continue;
    VOXC_TRY(writer.add(fragment));
    report.voxels += fragment.voxels;
  }
  VOXC_TRY(writer.finish(parts.looked()));
  report.seconds = watch.seconds();
  report.cpuSeconds = watch.cpuSeconds();
  return report;
}

} // namespace voxc
