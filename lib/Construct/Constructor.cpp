// Building volumes: compile, run.
#include "Construct/Fragments/FragmentSet.h"
#include "Construct/Parts/EditedParts.h"
#include "Construct/Parts/ParallelParts.h"
#include "ConstructorState.h"

#include "voxc/Layout/Values.h"
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
  auto construction = VOXC_TRY(ConstructionOfFormat::compile(format, cache));
  return Constructor(std::make_unique<State>(State{std::move(construction), watch.seconds()}));
}

std::unique_ptr<RoundedSource> roundedAs(const Layout &layout, VoxelSource &source) {
  const Rounding rounding = roundingOf(layout.payload);
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

BuildResult Constructor::build(VoxelSource &exact, const BuildOptions &options) const {
  const auto rounded = roundedAs(state_->layout(), exact);
  auto built = buildVoxels(rounded ? *rounded : exact, options);
  if (built && rounded)
    built->report.colourError = rounded->error();
  return built;
}

BuildResult Constructor::buildVoxels(VoxelSource &source, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  VOXC_TRY(checkFits(source.extent(), state_->format()));
  const double readBefore = source.readSeconds();
  const PartGrid grid = PartGrid::of(source, state_->layout());
  const auto build = [&]() -> BuildResult {
    if (options.threads <= 1 || grid.count() == 1 || !source.view())
      return buildWhole(source, state_->construction, options);
    auto parts =
        VOXC_TRY(ParallelParts::start(source, state_->functions(), state_->layout(), grid, 0, grid.count(),
                                      options.threads, options.memory, options.progress));
    return joinParts(*parts, infoOf(source, state_->format(), options), state_->construction, options,
                     Origin::Built);
  };
  auto built = build();
  if (built)
    built->report.readSeconds = source.readSeconds() - readBefore;
  return built;
}

BuildResult Constructor::edit(const std::shared_ptr<const Volume> &volume,
                              const std::vector<VoxelEdit> &edits, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  if (!(volume->format() == state_->format()))
    return Error::input("the volume is of the format " + toString(volume->format()) + ", not " +
                        toString(state_->format()));
  auto source = VOXC_TRY(makeEditedSource(volume, edits));
  const auto rounded = roundedAs(state_->layout(), *source);
  VolumeInfo info = infoOf(*source, state_->format(), options);
  auto parts = VOXC_TRY(EditedParts::create(*volume, rounded ? rounded->view() : source->view(), edits,
                                            state_->functions(), options));
  // What a loader has let through may be shared as no build does it: its parts are proved once more together.
  auto built = joinParts(*parts, std::move(info), state_->construction, options, Origin::Foreign);
  if (built && rounded)
    built->report.colourError = rounded->error();
  return built;
}

PartNumbers partNumbersOf(const VoxelSource &source, const Format &format) {
  const PartGrid grid = PartGrid::of(source, layoutOf(format));
  return {grid.log2Side, grid.count()};
}

Expected<void> Constructor::checkFormat(const FragmentSet &fragments) const {
  const Format &theirs = fragments.info().volume.format;
  if (theirs == state_->format())
    return {};
  return Error::input("the fragments are of the format " + toString(theirs) + ", not " +
                      toString(state_->format()));
}

BuildResult Constructor::mergeOpened(Expected<FragmentSet> fragments, const BuildOptions &options) const {
  if (!fragments)
    return fragments.error();
  VOXC_TRY(checkFormat(*fragments));
  return joinParts(*fragments, fragments->info().volume, state_->construction, options, Origin::Foreign);
}

BuildResult Constructor::merge(const std::vector<std::string> &paths, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  return mergeOpened(FragmentSet::open(paths, options.memory), options);
}

BuildResult Constructor::mergeRun(const std::vector<std::string> &paths, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  return mergeOpened(FragmentSet::openRun(paths, options.memory), options);
}

} // namespace voxc
