// voxc-gpu-day: measures and checks kernels on a machine that has a driver and nothing else
// (scripts/gpu-day.sh).
#include "Commands.h"
#include "Table.h"

#include "common/Command.h"
#include "common/CommandLine.h"

#include <algorithm>
#include <functional>

namespace voxc::gpu {
namespace {

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

void declareDistances(const tool::CommandLine &command, Options &options) {
  command.add("--side", options.side, "Pixels of each side of a picture").takes("N").showsDefault();
  command.add("volume", options.volume, "The scene, in any format").required().takes("VOLUME.hvx");
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
  command
      .add("--nodes", options.nodes,
           "What a tracer by hand traces through, or a CUDA program that reads no volume of voxc")
      .takes("NODES.bin");
  command.add("--group", options.groups, "Measure workgroups of this size too; may be given several times")
      .takes("N")
      .repeated();
  command.addFlag("--at-once", options.atOnce, "Measure one dispatch that does all, too");
  command.addFlag("--follow", options.follows, "Measure how long a tracer takes to follow edits, too");
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
  add("distances", "Make the rays of a camera from farther and farther away, and the oracle's hits",
      gpu::declareDistances, gpu::makeDistances);
  add("measure", "Measure a volume, or a tracer by hand, on rays", gpu::declareMeasure, gpu::measure);
  add("lattice", "Check kernels on hard rays, against integers, on the device", gpu::declareLattice,
      gpu::checkHardRays);
  add("table", "Make one JSON, records and a table of figures", gpu::declareTable,
      [](const gpu::Options &of) { return gpu::writeTables(of.folder, of.output); });
  program.requireCommands(1, 1);
  return tool::runTool(program, argc, argv, [&] {
    return std::ranges::find_if(commands, [](const Command &of) { return of.line.isGiven(); })->run();
  });
}
