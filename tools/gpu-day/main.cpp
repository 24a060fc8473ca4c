// voxc-gpu-day: measures and checks kernels on a machine that has a driver and nothing else
// (scripts/gpu-day.sh).
#include "CudaSubject.h"
#include "KernelSubject.h"
#include "LatticeSubject.h"
#include "Mapped.h"
#include "PeerSubject.h"
#include "RaySets.h"
#include "Table.h"

#include "common/CameraFile.h"
#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Files.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace voxc::gpu {
namespace {

namespace fs = std::filesystem;
using tool::Json;

struct Options {
  std::string volume, folder, output, device, cameras, label, scene;
  std::vector<std::string> kernels, cudas, only;
  std::vector<std::uint32_t> groups;
  std::string peer, nodes;
  std::string size = "3840x2160";
  double seconds = 0.1;
  bool atOnce = false;
  LatticeOptions lattice;
  std::string programs;
};

/// The cameras of a file whose names are that of the scene, or begin with it and a dash; all if there are
/// none.
Expected<std::vector<std::string>> namesOfCameras(const Options &options) {
  auto names = tool::cameraNames(options.cameras);
  if (!names)
    return names;
  std::vector<std::string> own;
  std::ranges::copy_if(*names, std::back_inserter(own), [&](const std::string &name) {
    return name == options.scene || name.starts_with(options.scene + "-");
  });
  return own.empty() ? names : own;
}

/// `rays VOLUME CAMERAS.json -o DIR`
Expected<void> makeRays(const Options &options) {
  const auto volume = Volume::load(options.volume, {.trusted = true});
  if (!volume)
    return volume.error();
  const auto names = namesOfCameras(options);
  if (!names)
    return names.error();
  int width = 0, height = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d", &width, &height) != 2 || width < 1 || height < 1 ||
      width > tool::kMaxPictureSide || height > tool::kMaxPictureSide)
    return Error::usage("--size is '" + options.size + "'; it should be WxH, pixels of a picture");
  std::vector<NamedCamera> cameras;
  for (const std::string &name : *names) {
    const auto of = tool::readCamera(options.cameras, name);
    if (!of)
      return of.error();
    cameras.push_back({name, cameraFromAngles(volume->info().extent, of->position, of->pitch, of->yaw,
                                              of->fov, width, height)});
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

/// Of NAME.KIND.spv or NAME.KIND.ptx.
std::string kindOf(const std::string &path) { return fs::path(path).stem().extension().string().erase(0, 1); }

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
  const KernelOptions how{options.seconds, options.groups, options.atOnce};
  const auto subject = KernelSubject::make(gpu, *volume, how);
  if (!subject)
    return subject.error();
  // One that a device does not take is told of; the others are measured.
  Json kernels = Json::object();
  const auto keep = [&](const std::string &path, Expected<Json> rows) {
    kernels[kindOf(path)] = rows ? std::move(*rows) : Json{{"failed", rows.error().message}};
  };
  for (const std::string &path : options.kernels) {
    const auto kernel = Kernel::load(path);
    if (!kernel)
      return kernel.error();
    keep(path, subject->measure(*kernel, sets));
  }
  for (const std::string &path : options.cudas) {
    const auto code = readTextFile(path);
    if (!code)
      return code.error();
    keep(path, measureCuda(*code, *volume, sets, options.seconds));
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

/// `lattice VOLUME --kernel K.spv --programs DIR`
Expected<void> lattice(const Options &options) {
  const auto gpu = Gpu::open(options.device);
  if (!gpu)
    return gpu.error();
  const auto volume = Volume::load(options.volume, {.trusted = true});
  if (!volume)
    return volume.error();
  const auto lattice = MappedBytes::open((fs::path(options.programs) / "lattice.spv").string());
  if (!lattice)
    return lattice.error();
  const auto compare = MappedBytes::open((fs::path(options.programs) / "compare.spv").string());
  if (!compare)
    return compare.error();
  Json figures{{"scene", options.scene}, {"label", options.label}, {"device", deviceJson(gpu->facts())}};
  figures["format"] = toString(volume->format());
  std::uint64_t wrong = 0;
  for (const std::string &path : options.kernels) {
    const auto kernel = Kernel::load(path);
    if (!kernel)
      return kernel.error();
    auto checked =
        checkLattice(*gpu, *volume, *kernel, {lattice->as<std::uint32_t>(), compare->as<std::uint32_t>()},
                     options.lattice);
    if (!checked)
      return checked.error();
    wrong += (*checked)["wrong"].get<std::uint64_t>();
    figures["lattice"][kindOf(path)] = std::move(*checked);
  }
  if (auto written = tool::writeText(options.output, figures.dump(1) + "\n"); !written)
    return written;
  if (wrong > 0)
    return Error::input(std::to_string(wrong) + " hits are not the exact ones");
  return {};
}

void declareLattice(const tool::CommandLine &command, Options &options) {
  command.add("volume", options.volume, "A volume of 128 voxels an axis at most")
      .required()
      .takes("VOLUME.hvx");
  command.add("--kernel", options.kernels, "Its kernels, as NAME.PRECISION.spv; may be given several times")
      .takes("KERNEL.spv")
      .required()
      .repeated();
  command.add("--programs", options.programs, "Folder with lattice.spv and compare.spv")
      .required()
      .takes("DIR");
  command.add("--count", options.lattice.rays, "Rays for each kernel").takes("N").showsDefault();
  command.add("--seed", options.lattice.seed, "Another number draws other rays").takes("N").showsDefault();
  command.add("--seconds", options.lattice.seconds, "End after so much time").takes("S");
  command.add("--device", options.device, "The device whose name contains this").takes("NAME");
  command.add("--scene", options.scene, "The scene's name in the figures").takes("NAME");
  command.add("--label", options.label, "The format's name in the figures").takes("NAME");
  command.add("-o,--output", options.output, "The figures, as JSON").required().takes("FILE");
}

void declareRays(const tool::CommandLine &command, Options &options) {
  command.add("--size", options.size, "Pixels of a picture").takes("WxH").showsDefault();
  command.add("--scene", options.scene, "Take its cameras alone, NAME and NAME-..., if there are some")
      .takes("NAME");
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
  command
      .add("--cuda", options.cudas,
           "A CUDA program of trace.cu, as NAME.KIND.ptx; may be given several times")
      .takes("CODE.ptx")
      .repeated();
  command.add("--peer", options.peer, "A tracer by hand in place of a volume").takes("KERNEL.spv");
  command.add("--nodes", options.nodes, "What it traces through").takes("NODES.bin");
  command.add("--group", options.groups, "Measure workgroups of this size too; may be given several times")
      .takes("N")
      .repeated();
  command.addFlag("--at-once", options.atOnce, "Measure one dispatch that does all, too");
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
  add("lattice", "Check kernels on hard rays, against integers, on the device", gpu::declareLattice,
      gpu::lattice);
  add("table", "Make one JSON, records and a table of figures", gpu::declareTable,
      [](const gpu::Options &of) { return gpu::writeTables(of.folder, of.output); });
  program.requireCommands(1, 1);
  return tool::runTool(program, argc, argv, [&] {
    return std::ranges::find_if(commands, [](const Command &of) { return of.line.isGiven(); })->run();
  });
}
