// The scenes that hard rays are traced in, at any extent: the built-in ones, and an input.
#pragma once

#include "common/CommandLine.h"
#include "options/InputArguments.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <memory>
#include <string>
#include <vector>

namespace voxc::tool {

class HardRayScenes {
public:
  /// Adds INPUT with its options, and --scene, to a command.
  void declare(const CommandLine &command);

  /// The names of all scenes that are asked for, the input last as "input". Error: an unknown name.
  Expected<std::vector<std::string>> names() const;
  /// A reader of a scene; an input must fit into the extent. Errors: as `openInput`; an unknown name.
  Expected<std::unique_ptr<VoxelSource>> open(const std::string &name, Int3 extent,
                                              const Progress &progress) const;

private:
  std::string input_;
  InputArguments inputArguments_;
  std::vector<std::string> chosen_;
};

} // namespace voxc::tool
