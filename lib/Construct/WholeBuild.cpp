// Hosts of whole volumes.
#include "WholeBuild.h"

#include "Construct/Host/SourceHost.h"
#include "ConstructorState.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Support/EmbeddedFile.h"

namespace voxc {

Expected<ConstructionOfFormat> ConstructionOfFormat::compile(const Format &format,
                                                             const CompileCache *cache) {
  auto plan = VOXC_TRY(makePlan(format));
  const std::string text = emitConstruct(plan);
  // -O1: a third less compile time than -O2, and builds that are as fast; they wait for the source, not for
  // this code. Only sweeps over distances gain from vectors.
  std::vector<MemoryFile> files = {{"construct.cpp", text}};
  for (const EmbeddedFile &header : constructHeaders())
    files.push_back({std::string(header.path), header.text});
  auto code =
      VOXC_TRY(JitCode::compile(files, {.optimisation = 1, .vectorLoops = true}, cache, toString(format)));
  auto whole = code.find("voxc_construct");
  auto part = code.find("voxc_construct_part");
  if (!whole || !part)
    return whole ? part.error() : whole.error();
  const ConstructCode functions(reinterpret_cast<ConstructCode::Whole>(*whole),
                                reinterpret_cast<ConstructCode::Part>(*part));
  return ConstructionOfFormat{storageFormat(format), std::move(plan.layout), std::move(code), functions};
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

/// Error: something is left.
Expected<void> checkEnd(PartStream &parts) {
  const auto left = parts.next();
  if (left.failed())
    return left.error();
  if (!left.isEnd())
    return Error::input("a part lies where the format has no voxels");
  return {};
}

} // namespace

BuildResult buildWhole(VoxelSource &source, const ConstructionOfFormat &construction,
                       const BuildOptions &options, std::uint64_t emptyWords) {
  auto build = VOXC_TRY(VolumeBuild::start(infoOf(source, construction.format, options), construction.layout,
                                           options, emptyWords));
  WholeHost host(source, *build, construction.layout.voxelFacts(), options.progress);
  const auto root = construction.functions.whole(host);
  if (!root)
    return {root.error(), build->wordsReached()};
  auto built = build->finish(*root, host.voxels(), host.colour());
  return {std::move(built), build->wordsReached()};
}

BuildResult joinParts(PartStream &parts, VolumeInfo info, const ConstructionOfFormat &construction,
                      const BuildOptions &options, Origin origin) {
  const Int3 extent = info.extent;
  auto build = VOXC_TRY(VolumeBuild::start(std::move(info), construction.layout, options));
  WholeMergeHost host(parts, construction.layout, extent, *build, options.progress);
  const auto root = construction.functions.whole(host);
  if (!root)
    return {root.error(), build->wordsReached()};
  if (auto end = checkEnd(parts); !end)
    return {end.error(), build->wordsReached()};
  auto built = build->finish(*root, host.voxels(), host.colour(), origin);
  return {std::move(built), build->wordsReached()};
}

} // namespace voxc
