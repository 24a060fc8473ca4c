// Options that choose passes: a flag for each registered pass, and --passes=a,b; they run as they are
// written.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Passes/Pass.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// Which passes a command offers: walk passes alone where the volume is finished already.
enum class PassChoice { All, WalkOnly };

/// The passes named on a command line, in the order of the command line.
class PassOptions {
public:
  /// Adds the options to `command`, which must outlive this.
  void declare(const CommandLine &command, PassChoice choice);

  /// The names as written; only after `command` has parsed. Unknown ones are left for `runPasses` to name.
  std::vector<std::string> names() const;

  /// Runs the chosen passes on `format`. Error `Usage`: a storage pass where only walk passes apply.
  Expected<void> apply(Format &format, const PipelineOptions &options = {}) const;

private:
  std::optional<CommandLine> command_;
  PassChoice choice_ = PassChoice::All;
};

} // namespace voxc::tool
