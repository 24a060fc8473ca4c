// --payload auto: the payload by what the input's voxels are like.
#pragma once

#include "common/CommandLine.h"
#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include "voxc/Facts/PayloadChoice.h"

#include <functional>
#include <memory>
#include <string>

namespace voxc::tool {

class PayloadOption {
public:
  /// Makes the format that the command line says, of a payload; an error if it has none of this kind.
  using Form = std::function<Expected<Format>(const PayloadChoice &)>;

  void declare(const CommandLine &command);
  bool isAuto() const { return !payload_.empty(); }

  /// Measures the voxels and gives the format the smallest payload that keeps all of their colours; adds to
  /// the figures what it is and why. The build proves what the payload states. Errors: those of measuring;
  /// `Usage`, the format has a payload already.
  Expected<void> apply(Format &format, const Form &form, VoxelSource &source,
                       const std::shared_ptr<WorkingMemory> &memory, const Progress &progress,
                       Json &figures) const;

private:
  std::string payload_;
};

} // namespace voxc::tool
