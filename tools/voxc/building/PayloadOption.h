// --payload auto: the payload by what the input's voxels are like.
#pragma once

#include "common/CommandLine.h"
#include "common/Json.h"
#include "voxc/Facts/PayloadChoice.h"
#include "voxc/IR/Format.h"

#include <functional>
#include <string>

namespace voxc::tool {

class PayloadOption {
public:
  /// Makes the format that the command line says, of a payload; an error if it has none of this kind.
  using Form = std::function<Expected<Format>(const PayloadChoice &)>;

  void declare(const CommandLine &command);
  bool isAuto() const { return !payload_.empty(); }

  /// `Usage`, the format has a payload already, so that none can be chosen.
  Expected<void> check(const Format &format) const;
  /// Gives the format the smallest payload that keeps all colours of the voxels, as it is formed, and counts
  /// of octants where short pointers have counts; adds to the figures what it is and why. The build proves
  /// what the payload states.
  Expected<void> apply(Format &format, const Form &form, const Facts &facts, Json &figures) const;

private:
  std::string payload_;
};

} // namespace voxc::tool
