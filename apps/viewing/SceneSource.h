// Where the viewer's scenes come from: a volume or an input, and the devices that trace.
#pragma once

#include "common/Command.h"
#include "common/CommandLine.h"
#include "frontend/PassOptions.h"
#include "options/BuildArguments.h"
#include "options/InputArguments.h"
#include "tracing/DeviceMemory.h"
#include "view/Scene.h"
#include "voxc/Construct/Constructor.h"

#include <string>
#include <vector>

namespace voxc::tool {

class SceneSource {
public:
  /// Adds INPUT, --format, the passes, --device, --threads, --device-memory, --allow-coarse and the options
  /// of inputs and volumes to a command.
  void declare(const CommandLine &command);
  /// Looks at the options before any work. Error: `Usage`.
  Expected<void> check() const;

  const std::string &input() const { return input_; }
  unsigned threads() const { return building_.threads; }
  /// Whether and how the volume is traced by its pages.
  const DeviceMemory &memory() const { return memory_; }
  /// Makes kernels that take rays with bounds.
  void useBounds() { hasBounds_ = true; }
  /// The scene that was asked for.
  view::SceneWish wish() const { return {"", device_}; }
  /// Makes this and other scenes of the input. It refers to this object.
  view::SceneMaker maker(const CommonOptions &common);

private:
  bool isVolume() const;
  Expected<view::Model> openPages();
  Expected<view::Model> loadVolume(const Progress &progress) const;
  Expected<view::Model> modelOf(Volume volume) const;
  Expected<view::Model> buildModel(const std::string &text, const Progress &progress) const;
  bool isAnimation(const Input &input, const Format &format) const;
  Expected<Volume> buildFrames(const Format &format, Input input, const InputOptions &options,
                               const BuildOptions &building) const;
  static Expected<Volume> buildAlone(const Format &format, VoxelSource &source, const BuildOptions &building);
  Expected<view::Model> suggestModel(const CommonOptions &common, const Progress &progress) const;
  Expected<view::Model> makeModel(const std::string &text, const CommonOptions &common,
                                  const Progress &progress);
  Expected<TraceSession> openTracing(const std::string &device, unsigned threads,
                                     const CommonOptions &common) const;
  Expected<view::Tracers> makeTracers(const view::Model &model, const CommonOptions &common,
                                      std::string &device) const;
  Expected<view::Tracers> makePagedTracers(const view::Model &model, const CommonOptions &common,
                                           TraceSession tracing) const;
  Format kernelFormat(const view::Model &model) const;

  std::string input_, format_, device_;
  bool trusted_ = false, hasBounds_ = false;
  InputArguments inputArguments_;
  BuildArguments building_;
  DeviceMemory memory_; ///< Its file stays open as long as this.
  PassOptions passes_;
};

/// The devices that the viewer offers: the usable ones of Vulkan, then cpu.
std::vector<std::string> deviceNames();

} // namespace voxc::tool
