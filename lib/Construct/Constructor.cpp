// Building volumes: emit, compile, run.
#include "voxc/Construct/Constructor.h"

#include "BuildHost.h"
#include "Jit.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Support/Stopwatch.h"

namespace voxc {
namespace {

using ConstructFunction = std::uint32_t (*)(const construct::Host *);

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
  ConstructFunction function;
  double compileSeconds;
};

Constructor::Constructor(std::unique_ptr<State> state) : state_(std::move(state)) {}
Constructor::~Constructor() = default;
Constructor::Constructor(Constructor &&) noexcept = default;

double Constructor::compileSeconds() const { return state_->compileSeconds; }

Expected<Constructor> Constructor::compile(const Format &format) {
  const Stopwatch watch;
  const std::string text = emitConstruct(makePlan(format));
  auto code = JitCode::compile({{"construct.cpp", text}, {"voxc_construct.h", constructHeader()}});
  if (!code)
    return code.error();
  auto address = code->find("voxc_construct");
  if (!address)
    return address.error();
  const auto function = reinterpret_cast<ConstructFunction>(*address);
  return Constructor(
      std::make_unique<State>(State{storageFormat(format), std::move(*code), function, watch.seconds()}));
}

Expected<Built> Constructor::build(VoxelSource &source, const BuildOptions &options) const {
  if (auto fits = checkFits(source.extent(), state_->format); !fits)
    return fits.error();
  const Stopwatch watch;
  BuildHost host(source, state_->format, options.progress);
  const construct::Host interface = host.interface();
  const std::uint32_t root = state_->function(&interface);
  if (host.failure())
    return *host.failure();
  if (auto error = source.failure())
    return *error;
  options.progress.at("build", 1.0);

  VolumeInfo info;
  info.format = state_->format;
  info.extent = source.extent();
  info.voxelToModel = source.voxelToModel();
  info.voxels = host.voxels();
  info.provenance = options.provenance;
  BuildReport report{0, host.voxels(), host.uniqueNodes(), host.sharedNodes()};
  Volume volume(std::move(info), host.takeWords(root));
  report.seconds = watch.seconds();
  return Built{std::move(volume), report};
}

} // namespace voxc
