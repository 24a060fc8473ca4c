// Building volumes: emit, compile, run.
#include "voxc/Construct/Constructor.h"

#include "EditedParts.h"
#include "FragmentSet.h"
#include "JoinedParts.h"
#include "ParallelParts.h"
#include "SourceHost.h"
#include "VolumeBuild.h"

#include "Jit/Jit.h"
#include "Source/CubeTools.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Layout/Values.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc {
namespace {

Expected<void> checkFits(Int3 extent, const Format &format) {
  const Int3 limit = format.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (extent[axis] < 0 || extent[axis] > limit[axis])
      return Error::input("the input has " + std::to_string(extent.x) + " x " + std::to_string(extent.y) +
                          " x " + std::to_string(extent.z) + " voxels; the format holds " +
                          std::to_string(limit.x) + " x " + std::to_string(limit.y) + " x " +
                          std::to_string(limit.z));
  return {};
}

} // namespace

/// Fragments are built of parts up to 2^this times as large as the smallest: words that a part has twice are
/// written once, and what a part takes in memory stays little.
constexpr int kLog2LargerPart = 2;

/// Parts of a fragment are joined to one as long as they take no more than this share of the memory.
constexpr std::uint64_t kPartsInMemory = 8;

struct Constructor::State {
  Format format;
  JitCode code;
  ConstructCode functions;
  double compileSeconds;
};

Constructor::Constructor(std::unique_ptr<State> state) : state_(std::move(state)) {}
Constructor::~Constructor() = default;
Constructor::Constructor(Constructor &&) noexcept = default;

double Constructor::compileSeconds() const { return state_->compileSeconds; }

Expected<Constructor> Constructor::compile(const Format &format, const CompileCache *cache) {
  const Stopwatch watch;
  const auto plan = makePlan(format);
  if (!plan)
    return plan.error();
  const std::string text = emitConstruct(*plan);
  // -O1: a third less compile time than -O2, and builds that are as fast; they wait for the source, not for
  // this code.
  auto code = JitCode::compile({{"construct.cpp", text}, {"voxc_construct.h", constructHeader()}},
                               {.optimisation = 1}, cache);
  if (!code)
    return code.error();
  auto whole = code->find("voxc_construct");
  auto part = code->find("voxc_construct_part");
  if (!whole || !part)
    return whole ? part.error() : whole.error();
  const ConstructCode functions = {reinterpret_cast<decltype(ConstructCode::whole)>(*whole),
                                   reinterpret_cast<decltype(ConstructCode::part)>(*part)};
  return Constructor(
      std::make_unique<State>(State{storageFormat(format), std::move(*code), functions, watch.seconds()}));
}

namespace {

/// The source in the colours that the format's payload keeps, if it rounds them.
std::unique_ptr<RoundedSource> roundedAs(const Format &format, VoxelSource &source) {
  const Rounding rounding = roundingOf(layoutOf(format).payload);
  return rounding ? std::make_unique<RoundedSource>(source, rounding) : nullptr;
}

BuildOptions withMemory(BuildOptions options) {
  if (!options.memory)
    options.memory = WorkingMemory::createDefault();
  return options;
}

VolumeInfo infoOf(const VoxelSource &source, const Format &format, const BuildOptions &options) {
  return {format, source.extent(), source.voxelToModel(), 0, options.provenance};
}

/// The host of a volume that is built in one go.
class WholeHost final : public SourceHost {
public:
  WholeHost(VoxelSource &source, VolumeBuild &build, VoxelFacts facts, const Progress &progress)
      : SourceHost(source, build.store(), facts, progress), values_(build.values()) {}

protected:
  void putValue(std::uint32_t value) override { values_.put({&value, 1}); }

private:
  ValueStore &values_;
};

Expected<Built> buildWhole(VoxelSource &source, const ConstructCode &code, const Format &format,
                           const BuildOptions &options) {
  auto build = VolumeBuild::start(infoOf(source, format, options), options);
  if (!build)
    return build.error();
  WholeHost host(source, **build, layoutOf(format).voxelFacts(), options.progress);
  const std::uint32_t root = code.whole(&host.interface());
  if (auto error = source.failure())
    return *error;
  return (*build)->finish(root, host.voxels(), host.colour());
}

/// The host of a volume that is made of parts.
class WholeMergeHost final : public MergeHost {
public:
  WholeMergeHost(PartStream &parts, const Layout &layout, Int3 extent, VolumeBuild &build,
                 const Progress &progress)
      : MergeHost(parts, layout, extent, build.store(), progress), values_(build.values()) {}

protected:
  void putValues(std::span<const std::uint32_t> values) override { values_.put(values); }

private:
  ValueStore &values_;
};

/// Joins the parts of a stream to a volume.
Expected<Built> joinParts(PartStream &parts, VolumeInfo info, const ConstructCode &code,
                          const BuildOptions &options, Origin origin) {
  const Layout layout = layoutOf(info.format);
  const Int3 extent = info.extent;
  auto build = VolumeBuild::start(std::move(info), options);
  if (!build)
    return build.error();
  WholeMergeHost host(parts, layout, extent, **build, options.progress);
  const std::uint32_t root = code.whole(&host.interface());
  if (!(*build)->store().failure() && parts.next())
    return Error::input("a part lies where the format has no voxels");
  return (*build)->finish(root, host.voxels(), host.colour(), origin);
}

} // namespace

Expected<Built> Constructor::build(VoxelSource &exact, const BuildOptions &options) const {
  const auto rounded = roundedAs(state_->format, exact);
  auto built = buildVoxels(rounded ? *rounded : exact, options);
  if (built && rounded)
    built->report.colourError = rounded->error();
  return built;
}

Expected<Built> Constructor::buildVoxels(VoxelSource &source, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  const Format &format = state_->format;
  if (auto fits = checkFits(source.extent(), format); !fits)
    return fits.error();
  const double readBefore = source.readSeconds();
  const PartGrid grid = PartGrid::of(source, layoutOf(format));
  const auto build = [&]() -> Expected<Built> {
    if (options.threads <= 1 || grid.count() == 1 || !source.view())
      return buildWhole(source, state_->functions, format, options);
    auto parts = ParallelParts::start(source, state_->functions, format, grid, 0, grid.count(),
                                      options.threads, options.memory, options.progress.stop);
    if (!parts)
      return parts.error();
    return joinParts(**parts, infoOf(source, format, options), state_->functions, options, Origin::Built);
  };
  auto built = build();
  if (built)
    built->report.readSeconds = source.readSeconds() - readBefore;
  return built;
}

Expected<Built> Constructor::edit(const std::shared_ptr<const Volume> &volume,
                                  const std::vector<VoxelEdit> &edits, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  if (!(volume->format() == state_->format))
    return Error::input("the volume is of the format " + toString(volume->format()) + ", not " +
                        toString(state_->format));
  auto source = makeEditedSource(volume, edits);
  if (!source)
    return source.error();
  const auto rounded = roundedAs(state_->format, **source);
  VolumeInfo info = infoOf(**source, state_->format, options);
  auto parts = EditedParts::create(*volume, rounded ? rounded->view() : (*source)->view(), edits,
                                   state_->functions, options);
  if (!parts)
    return parts.error();
  // What a loader has let through may be shared as no build does it: its parts are proved once more together.
  return joinParts(**parts, std::move(info), state_->functions, options, Origin::Foreign);
}

PartNumbers partNumbersOf(const VoxelSource &source, const Format &format) {
  const PartGrid grid = PartGrid::of(source, layoutOf(format));
  return {grid.log2Side, grid.count()};
}

Expected<BuildReport> Constructor::buildFragment(VoxelSource &source, std::uint64_t index,
                                                 std::uint64_t count, const std::string &path,
                                                 const BuildOptions &options) const {
  const auto [begin, end] = PartGrid::of(source, layoutOf(state_->format)).range(index, count);
  return buildFragment(source, FragmentShare{index, count, begin, end}, path, options);
}

Expected<BuildReport> Constructor::buildFragment(VoxelSource &exact, const FragmentShare &share,
                                                 const std::string &path, const BuildOptions &given) const {
  const Stopwatch watch;
  const BuildOptions options = withMemory(given);
  const Format &format = state_->format;
  const auto rounded = roundedAs(format, exact);
  VoxelSource &source = rounded ? *rounded : exact;
  if (auto fits = checkFits(source.extent(), format); !fits)
    return fits.error();
  const Layout layout = layoutOf(format);
  const PartGrid smallest = PartGrid::of(source, layout);
  const PartGrid grid = smallest.upTo(smallest.log2Side + kLog2LargerPart, layout);
  auto writer = FragmentWriter::create(
      path, {infoOf(source, format, options), grid.log2Side, share.index, share.count});
  if (!writer)
    return writer.error();
  auto parts = ParallelParts::start(source, state_->functions, format, grid, share.begin, share.end,
                                    std::max(options.threads, 1u), options.memory, options.progress.stop);
  if (!parts)
    return parts.error();
  BuildReport report;
  MortonProgress progress(source.extent(), options.progress);
  while (const auto cube = (*parts)->next()) {
    auto fragment = (*parts)->take();
    if (!fragment)
      return fragment.error();
    if (auto added = writer->add(*fragment); !added)
      return added.error();
    report.voxels += fragment->voxels;
    if (!progress.at(cube->low, report.voxels))
      return Error::interrupted();
  }
  if (auto finished = writer->finish(); !finished)
    return finished.error();
  if (rounded)
    report.colourError = rounded->error();
  report.readSeconds = source.readSeconds();
  report.scratchBytes = options.memory->scratchPeak();
  report.seconds = watch.seconds();
  report.cpuSeconds = watch.cpuSeconds();
  return report;
}

namespace {

Expected<void> checkFormat(const FragmentSet &fragments, const Format &format) {
  const Format &theirs = fragments.info().volume.format;
  if (theirs == format)
    return {};
  return Error::input("the fragments are of the format " + toString(theirs) + ", not " + toString(format));
}

bool isNextIn(const Cube &cube, FragmentSet &fragments) {
  const auto next = fragments.next();
  return next && mortonCode(next->low) - mortonCode(cube.low) < cellCount(cube.log2Side);
}

} // namespace

Expected<Built> Constructor::merge(const std::vector<std::string> &paths, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  auto fragments = FragmentSet::open(paths, options.memory);
  if (!fragments)
    return fragments.error();
  if (auto checked = checkFormat(*fragments, state_->format); !checked)
    return checked.error();
  return joinParts(*fragments, fragments->info().volume, state_->functions, options, Origin::Foreign);
}

Expected<BuildReport> Constructor::joinFragments(const std::vector<std::string> &paths,
                                                 const FragmentShare &share, const std::string &path,
                                                 const BuildOptions &given) const {
  const Stopwatch watch;
  const BuildOptions options = withMemory(given);
  auto fragments = FragmentSet::openRun(paths, options.memory);
  if (!fragments)
    return fragments.error();
  if (auto checked = checkFormat(*fragments, state_->format); !checked)
    return checked.error();
  const FragmentInfo &info = fragments->info();
  auto writer = FragmentWriter::create(path, {info.volume, info.log2Side, share.index, share.count});
  if (!writer)
    return writer.error();
  auto joined = JoinedParts::create(*fragments, state_->functions, options.memory);
  if (!joined)
    return joined.error();
  const std::uint64_t mostBytes = options.memory->bound() / kPartsInMemory;
  const Layout layout = layoutOf(info.volume.format);
  PartSequence cubes(
      PartGrid::of(info.volume.extent, layout, info.log2Side).upTo(kMaxLog2Extent, layout), share.begin,
      share.end, [&](const Cube &cube) { return !isNextIn(cube, *fragments); },
      [&](const Cube &cube) {
        return fragments->next()->log2Side < cube.log2Side && fragments->bytesIn(cube) > mostBytes;
      });
  BuildReport report;
  while (const auto cube = cubes.next()) {
    auto fragment = joined->join(*cube, options.progress);
    if (!fragment)
      return fragment.error();
    if (auto added = writer->add(*fragment); !added)
      return added.error();
    report.voxels += fragment->voxels;
  }
  if (fragments->next())
    return Error::input("a part lies outside the share of the volume that is merged");
  if (auto finished = writer->finish(); !finished)
    return finished.error();
  report.scratchBytes = options.memory->scratchPeak();
  report.seconds = watch.seconds();
  report.cpuSeconds = watch.cpuSeconds();
  return report;
}

Expected<FragmentShare> checkFragment(const std::string &path) {
  auto reader = FragmentReader::open(path);
  if (!reader)
    return reader.error();
  return FragmentShare{reader->info().index, reader->info().count, 0, 0};
}

Expected<Format> formatOfFragment(const std::string &path) {
  auto reader = FragmentReader::open(path);
  if (!reader)
    return reader.error();
  return reader->info().volume.format;
}

} // namespace voxc
