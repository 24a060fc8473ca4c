// Building volumes: emit, compile, run.
#include "ConstructorState.h"
#include "EditedParts.h"
#include "FragmentSet.h"
#include "ParallelParts.h"
#include "SourceHost.h"
#include "VolumeBuild.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/Values.h"
#include "voxc/Support/EmbeddedFile.h"
#include "voxc/Support/Stopwatch.h"

namespace voxc {

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
  // this code. Only sweeps over distances gain from vectors.
  std::vector<MemoryFile> files = {{"construct.cpp", text}};
  for (const EmbeddedFile &header : constructHeaders())
    files.push_back({std::string(header.path), header.text});
  auto code = JitCode::compile(files, {.optimisation = 1, .vectorLoops = true}, cache);
  if (!code)
    return code.error();
  auto whole = code->find("voxc_construct");
  auto part = code->find("voxc_construct_part");
  if (!whole || !part)
    return whole ? part.error() : whole.error();
  const ConstructCode functions(reinterpret_cast<ConstructCode::Whole>(*whole),
                                reinterpret_cast<ConstructCode::Part>(*part));
  return Constructor(
      std::make_unique<State>(State{storageFormat(format), std::move(*code), functions, watch.seconds()}));
}

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

namespace {

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
  const auto root = code.whole(host);
  if (!root)
    return root.error();
  return (*build)->finish(*root, host.voxels(), host.colour());
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
  const auto root = code.whole(host);
  if (!root)
    return root.error();
  if (const auto left = parts.next(); left.failed())
    return left.error();
  else if (!left.isEnd())
    return Error::input("a part lies where the format has no voxels");
  return (*build)->finish(*root, host.voxels(), host.colour(), origin);
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
                                      options.threads, options.memory, options.progress);
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

Expected<void> Constructor::checkFormat(const FragmentSet &fragments) const {
  const Format &theirs = fragments.info().volume.format;
  if (theirs == state_->format)
    return {};
  return Error::input("the fragments are of the format " + toString(theirs) + ", not " +
                      toString(state_->format));
}

Expected<Built> Constructor::mergeOpened(Expected<FragmentSet> fragments, const BuildOptions &options) const {
  if (!fragments)
    return fragments.error();
  if (auto checked = checkFormat(*fragments); !checked)
    return checked.error();
  return joinParts(*fragments, fragments->info().volume, state_->functions, options, Origin::Foreign);
}

Expected<Built> Constructor::merge(const std::vector<std::string> &paths, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  return mergeOpened(FragmentSet::open(paths, options.memory), options);
}

Expected<Built> Constructor::mergeRun(const std::vector<std::string> &paths,
                                      const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  return mergeOpened(FragmentSet::openRun(paths, options.memory), options);
}

} // namespace voxc
