// Building volumes: emit, compile, run.
#include "voxc/Construct/Constructor.h"

#include "FragmentSet.h"
#include "ParallelParts.h"
#include "SourceHost.h"
#include "VolumeBuild.h"

#include "Jit/Jit.h"
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

Expected<Constructor> Constructor::compile(const Format &format) {
  const Stopwatch watch;
  const auto plan = makePlan(format);
  if (!plan)
    return plan.error();
  const std::string text = emitConstruct(*plan);
  // -O1: a third less compile time than -O2, and builds that are as fast; they wait for the source, not for
  // this code.
  auto code = JitCode::compile({{"construct.cpp", text}, {"voxc_construct.h", constructHeader()}},
                               {.optimisation = 1});
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
  const construct::Host interface = host.interface();
  const std::uint32_t root = code.whole(&interface);
  if (auto error = source.failure())
    return *error;
  return (*build)->finish(root, host.voxels(), host.colour());
}

/// Joins the parts of a stream to a volume.
Expected<Built> joinParts(PartStream &parts, int log2Part, VolumeInfo info, const ConstructCode &code,
                          const BuildOptions &options, Origin origin) {
  const Layout layout = layoutOf(info.format);
  const Int3 extent = info.extent;
  auto build = VolumeBuild::start(std::move(info), options);
  if (!build)
    return build.error();
  MergeHost host(parts, log2Part, layout, extent, (*build)->store(), (*build)->values(), options.progress);
  const construct::Host interface = host.interface();
  const std::uint32_t root = code.whole(&interface);
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
    return joinParts(**parts, grid.log2Side, infoOf(source, format, options), state_->functions, options,
                     Origin::Built);
  };
  auto built = build();
  if (built)
    built->report.readSeconds = source.readSeconds() - readBefore;
  return built;
}

Expected<BuildReport> Constructor::buildFragment(VoxelSource &exact, std::uint64_t index, std::uint64_t count,
                                                 const std::string &path, const BuildOptions &given) const {
  const Stopwatch watch;
  const BuildOptions options = withMemory(given);
  const Format &format = state_->format;
  const auto rounded = roundedAs(format, exact);
  VoxelSource &source = rounded ? *rounded : exact;
  if (auto fits = checkFits(source.extent(), format); !fits)
    return fits.error();
  const PartGrid grid = PartGrid::of(source, layoutOf(format));
  const auto [begin, end] = grid.range(index, count);
  auto writer = FragmentWriter::create(path, {infoOf(source, format, options), grid.log2Side, index, count});
  if (!writer)
    return writer.error();
  auto parts = ParallelParts::start(source, state_->functions, format, grid, begin, end,
                                    std::max(options.threads, 1u), options.memory, options.progress.stop);
  if (!parts)
    return parts.error();
  BuildReport report;
  MortonProgress progress(source.extent(), options.progress);
  while (const auto low = (*parts)->next()) {
    auto fragment = (*parts)->take();
    if (!fragment)
      return fragment.error();
    if (auto added = writer->add(*fragment); !added)
      return added.error();
    report.voxels += fragment->voxels;
    if (!progress.at(*low, report.voxels))
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

Expected<Built> Constructor::merge(const std::vector<std::string> &paths, const BuildOptions &given) const {
  const BuildOptions options = withMemory(given);
  auto fragments = FragmentSet::open(paths, options.memory);
  if (!fragments)
    return fragments.error();
  const FragmentInfo &info = fragments->info();
  if (info.volume.format != state_->format)
    return Error::input("the fragments are of the format " + toString(info.volume.format) + ", not " +
                        toString(state_->format));
  return joinParts(*fragments, info.log2Side, info.volume, state_->functions, options, Origin::Foreign);
}

Expected<Format> formatOfFragment(const std::string &path) {
  auto reader = FragmentReader::open(path);
  if (!reader)
    return reader.error();
  return reader->info().volume.format;
}

} // namespace voxc
