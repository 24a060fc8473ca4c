// voxc-gpu-day: measures and checks kernels on a machine that has a driver and nothing else
// (scripts/gpu-day.sh).
#include "KernelSubject.h"
#include "Mapped.h"
#include "PeerSubject.h"
#include "RaySets.h"
#include "Table.h"

#include "common/CameraFile.h"
#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Files.h"

#include <algorithm>
#include <filesystem>
#include <functional>

namespace voxc::gpu {
namespace {

namespace fs = std::filesystem;
using tool::Json;

struct Options {
  std::string volume, folder, output, device, cameras, label, scene;
  std::vector<std::string> kernels, only;
  std::vector<std::uint32_t> groups;
  std::string peer, nodes;
  double seconds = 0.1;
};

/// `rays VOLUME CAMERAS.json -o DIR`
Expected<void> makeRays(const Options &options) {
  const auto volume = Volume::load(options.volume, {.trusted = true});
  if (!volume)
    return volume.error();
  const auto names = tool::cameraNames(options.cameras);
  if (!names)
    return names.error();
  std::vector<NamedCamera> cameras;
  for (const std::string &name : *names) {
    const auto of = tool::readCamera(options.cameras, name);
    if (!of)
      return of.error();
    const std::array<int, 2> size = of->size.value_or(std::array{3840, 2160});
    cameras.push_back({name, cameraFromAngles(volume->info().extent, of->position, of->pitch, of->yaw,
                                              of->fov, size[0], size[1])});
  }
  return makeRaySets(*volume, cameras, options.output);
}

/// The sets of a folder, by their names.
std::vector<std::string> setsOf(const Options &options) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry &entry : fs::directory_iterator(options.folder, ignored))
    if (const std::string name = entry.path().stem().string();
        entry.path().extension() == ".rays" &&
        (options.only.empty() || std::ranges::find(options.only, name) != options.only.end()))
      names.push_back(name);
  std::ranges::sort(names);
  return names;
}

/// The rays of a folder on the device, with the files that they come from.
struct Brought {
  std::vector<MappedBytes> files;
  std::vector<RaysThere> sets;
};

Expected<Brought> bringSets(const Gpu &gpu, const Options &options) {
  Brought brought;
  for (const std::string &name : setsOf(options)) {
    const std::string path = (fs::path(options.folder) / name).string();
    for (const char *const ending : {".rays", ".hits"}) {
      auto file = MappedBytes::open(path + ending);
      if (!file)
        return file.error();
      brought.files.push_back(std::move(*file));
    }
    const std::size_t last = brought.files.size() - 1;
    const auto rays = brought.files[last - 1].as<Ray>();
    const auto hits = brought.files[last].as<Hit>();
    if (rays.size() != hits.size())
      return Error::input("'" + path + ".hits' has not as many records as its rays");
    auto set = bringRays(gpu, name, rays, hits, kPeerColumns);
    if (!set)
      return set.error();
    brought.sets.push_back(std::move(*set));
  }
  if (brought.sets.empty())
    return Error::input("folder '" + options.folder + "' has no rays");
  return brought;
}

Json deviceJson(const GpuFacts &facts) {
  return {{"name", facts.name},
          {"driver", facts.driver},
          {"vulkan", facts.api},
          {"memory_bytes", facts.memoryBytes},
          {"processor", facts.isProcessor}};
}

Expected<Json> measureVolume(const Gpu &gpu, const Options &options, std::span<const RaysThere> sets,
                             Json &figures) {
  const auto volume = Volume::load(options.volume, {.trusted = true});
  if (!volume)
    return volume.error();
  figures["format"] = toString(volume->format());
  figures["extent"] = {volume->info().extent.x, volume->info().extent.y, volume->info().extent.z};
  figures["voxels"] = volume->info().voxels;
  figures["words"] = volume->words().size();
  figures["bytes"] = volume->words().size_bytes();
  const KernelOptions how{options.seconds, options.groups};
  const auto subject = KernelSubject::make(gpu, *volume, how);
  if (!subject)
    return subject.error();
  Json kernels = Json::object();
  for (const std::string &path : options.kernels) {
    const auto kernel = Kernel::load(path);
    if (!kernel)
      return kernel.error();
    auto rows = subject->measure(*kernel, sets);
    if (!rows)
      return rows.error();
    // KERNEL.PRECISION.spv
    kernels[fs::path(path).stem().extension().string().erase(0, 1)] = std::move(*rows);
  }
  return kernels;
}

Expected<Json> measureByHand(const Gpu &gpu, const Options &options, std::span<const RaysThere> sets) {
  const auto spirv = MappedBytes::open(options.peer);
  if (!spirv)
    return spirv.error();
  const auto nodes = MappedBytes::open(options.nodes);
  if (!nodes)
    return nodes.error();
  auto rows = measurePeer(gpu, spirv->as<std::uint32_t>(), nodes->as<std::uint32_t>(), sets, options.seconds);
  if (!rows)
    return rows.error();
  return Json{{"by hand", std::move(*rows)}};
}

/// `measure`: one volume or peer on all sets of a folder.
Expected<void> measure(const Options &options) {
  const auto gpu = Gpu::open(options.device);
  if (!gpu)
    return gpu.error();
  const auto brought = bringSets(*gpu, options);
  if (!brought)
    return brought.error();
  Json figures{{"scene", options.scene}, {"label", options.label}, {"device", deviceJson(gpu->facts())}};
  auto kernels = options.peer.empty() ? measureVolume(*gpu, options, brought->sets, figures)
                                      : measureByHand(*gpu, options, brought->sets);
  if (!kernels)
    return kernels.error();
  figures["kernels"] = std::move(*kernels);
  return tool::writeText(options.output, figures.dump(1) + "\n");
}

void declareRays(const tool::CommandLine &command, Options &options) {
  command.add("volume", options.volume, "The scene, in any format").required().takes("VOLUME.hvx");
  command.add("cameras", options.cameras, "Its cameras").required().takes("CAMERAS.json");
  command.add("-o,--output", options.output, "Folder for the rays and the oracle's hits")
      .required()
      .takes("DIR");
}

void declareMeasure(const tool::CommandLine &command, Options &options) {
  command.add("--rays", options.folder, "Folder of rays and hits").required().takes("DIR");
  command.add("--volume", options.volume, "A volume").takes("VOLUME.hvx");
  command.add("--kernel", options.kernels, "Its kernels, as NAME.PRECISION.spv; may be given several times")
      .takes("KERNEL.spv")
      .repeated();
  command.add("--peer", options.peer, "A tracer by hand in place of a volume").takes("KERNEL.spv");
  command.add("--nodes", options.nodes, "What it traces through").takes("NODES.bin");
  command.add("--group", options.groups, "Measure workgroups of this size too; may be given several times")
      .takes("N")
      .repeated();
  command.add("--set", options.only, "These rays alone; may be given several times").takes("NAME").repeated();
  command.add("--seconds", options.seconds, "Time each figure for so long").takes("S").showsDefault();
  command.add("--device", options.device, "The device whose name contains this").takes("NAME");
  command.add("--scene", options.scene, "The scene's name in the figures").takes("NAME");
  command.add("--label", options.label, "The format's name in the figures").takes("NAME");
  command.add("-o,--output", options.output, "The figures, as JSON").required().takes("FILE");
}

void declareTable(const tool::CommandLine &command, Options &options) {
  command.add("folder", options.folder, "Folder of figures that were measured").required().takes("DIR");
  command.add("-o,--output", options.output, "Folder for gpu-day.json, results.jsonl and table.md")
      .required()
      .takes("DIR");
}

} // namespace
} // namespace voxc::gpu

int main(int argc, char **argv) {
  using namespace voxc;
  const tool::CommandLine program(
      "voxc-gpu-day", "Measures and checks kernels on a machine that has a driver and nothing else.");
  gpu::Options options;
  struct Command {
    tool::CommandLine line;
    std::function<Expected<void>()> run;
  };
  std::vector<Command> commands;
  const auto add = [&](const char *name, const char *text, const auto &declare, const auto &run) {
    commands.push_back({program.addCommand(name, text), [&options, run] { return run(options); }});
    declare(commands.back().line, options);
  };
  add("rays", "Make the rays of a scene, and the oracle's hits", gpu::declareRays, gpu::makeRays);
  add("measure", "Measure a volume, or a tracer by hand, on rays", gpu::declareMeasure, gpu::measure);
  add("table", "Make one JSON, records and a table of figures", gpu::declareTable,
      [](const gpu::Options &of) { return gpu::writeTables(of.folder, of.output); });
  program.requireCommands(1, 1);
  return tool::runTool(program, argc, argv, [&] {
    return std::ranges::find_if(commands, [](const Command &of) { return of.line.isGiven(); })->run();
  });
}
