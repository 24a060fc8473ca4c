// voxc-edit-costs: how long edits of a volume take, how many words they add and how many bytes a copy of the
// volume asks for, beside the same edits by OpenVDB.
#include "Edits.h"
#include "TraceCosts.h"
#include "VdbEdits.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Support/UserCache.h"

#include <algorithm>
#include <cstdio>

namespace voxc::edits {
namespace {

struct Options {
  std::string volume, pasted, rays, device = "cpu";
  bool comparesVdb = false;
};

std::vector<VoxelWord> voxelsOf(const Volume &volume) {
  std::vector<VoxelWord> voxels;
  static_cast<void>(decode(volume, [&](const Cube &cube, std::uint32_t word) {
    const auto side = static_cast<int>(cube.side());
    for (int i = 0; i < side * side * side; ++i)
      voxels.push_back({cube.low + Int3{i % side, i / side % side, i / (side * side)}, word});
    return true;
  }));
  return voxels;
}

/// Seconds of single edits, sorted.
class Times {
public:
  template <typename Work> void add(const Work &work) {
    const Stopwatch watch;
    work();
    seconds_.push_back(watch.seconds());
  }
  double at(double share) {
    std::ranges::sort(seconds_);
    return 1e6 * seconds_[static_cast<std::size_t>(share * double(seconds_.size() - 1))];
  }

private:
  std::vector<double> seconds_;
};

class Measuring {
public:
  Measuring(const Volume &volume, std::shared_ptr<const Volume> pasted, EditableVolume edited)
      : pasted_(std::move(pasted)), edited_(std::move(edited)), places_(placesOn(volume, 100000)) {}

  Expected<void> run(VdbEdits *vdb) {
    const auto pastedVoxels = pasted_ ? voxelsOf(*pasted_) : std::vector<VoxelWord>();
    std::printf("%-24s %10s %10s %10s %10s %12s\n", "edit", "median us", "p90 us", "words", "copied B",
                vdb ? "OpenVDB us" : "");
    for (const EditKind &kind : editKinds())
      if (kind.shape != Edit::Paste || pasted_)
        VOXC_TRY(row(kind, vdb, pastedVoxels));
    std::printf("%llu words, of which the first volume had %llu\n", (unsigned long long)edited_.words(),
                (unsigned long long)firstWords_);
    return {};
  }

private:
  Expected<void> row(const EditKind &kind, VdbEdits *vdb, const std::vector<VoxelWord> &pastedVoxels) {
    Times own, theirs;
    const std::vector<Edit> edits = editsOf(kind, places_);
    const std::uint64_t before = edited_.words();
    std::uint64_t copied = 0;
    edited_.takeChanges();
    for (const Edit &edit : edits) {
      Expected<EditReport> report = EditReport{};
      own.add([&] { report = edited_.apply(*changeOf(edit, pasted_)); });
      if (!report)
        return report.error();
      for (const WordRange &range : edited_.takeChanges())
        copied += (range.end - range.first) * sizeof(std::uint32_t);
      if (vdb)
        theirs.add([&] { vdb->apply(edit, pastedVoxels); });
    }
    const auto count = static_cast<double>(edits.size());
    std::printf("%-24s %10.2f %10.2f %10.1f %10.0f", std::string(kind.name).c_str(), own.at(0.5), own.at(0.9),
                double(edited_.words() - before) / count, double(copied) / count);
    std::printf(vdb ? " %12.2f\n" : "\n", vdb ? theirs.at(0.5) : 0);
    return {};
  }

  std::shared_ptr<const Volume> pasted_;
  EditableVolume edited_;
  std::uint64_t firstWords_ = edited_.words();
  std::vector<Int3> places_;
};

/// A thousand spheres of 16^3, every second of which clears, and then rays.
Expected<void> traceAfterEdits(EditableVolume &edited, const Options &options) {
  const std::vector<Int3> places = placesOn(*edited.volume(), 1000);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (auto applied = edited.apply(*makeSphereChange(places[i], 8, i % 2 == 0 ? 0 : rgba(255, 0, 255)));
        !applied)
      return applied.error();
  return compareTraces(edited, options.rays, options.device);
}

Expected<void> measure(const Options &options) {
  auto volume = VOXC_TRY(Volume::load(options.volume, {.trusted = true}));
  std::shared_ptr<const Volume> pasted;
  if (!options.pasted.empty()) {
    auto loaded = VOXC_TRY(Volume::load(options.pasted));
    pasted = std::make_shared<const Volume>(std::move(loaded));
  }
  const Stopwatch watch;
  auto edited = VOXC_TRY(EditableVolume::create(volume, {.cache = compileCache()}));
  std::printf("made editable in %.3f s, of which %.3f compiling\n", watch.seconds(), edited.compileSeconds());
  const auto vdb = options.comparesVdb ? VdbEdits::create(volume) : nullptr;
  if (!options.rays.empty())
    return traceAfterEdits(edited, options);
  return Measuring(volume, pasted, std::move(edited)).run(vdb.get());
}

} // namespace
} // namespace voxc::edits

int main(int argc, char **argv) {
  const voxc::tool::CommandLine command("voxc-edit-costs", "Measures what edits of a volume cost.");
  voxc::edits::Options options;
  command.add("VOLUME", options.volume, "A .hvx file").required().takes("");
  command.add("--paste", options.pasted, "A .hvx file that is pasted").takes("W.hvx");
  command.addFlag("--openvdb", options.comparesVdb, "Do the same edits by OpenVDB's accessor, in turn");
  command
      .add("--rays", options.rays,
           "Do a thousand edits of 16^3, and trace these rays then, through the edited volume and a build of "
           "it in turn")
      .takes("FILE");
  command.add("--device", options.device, "Where to trace").takes("NAME").showsDefault();
  return voxc::tool::runTool(command, argc, argv, [&] { return voxc::edits::measure(options); });
}
