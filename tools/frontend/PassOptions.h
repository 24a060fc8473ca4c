// Options that choose passes: a flag for each registered pass, and --passes=a,b.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Passes/Pass.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

/// Which passes a command offers: traversal passes alone where the volume is finished already; `OfInput`,
/// all, of which the input may tell the number (`--short-pointers=auto`); `Pipeline`, all, in the order
/// written.
enum class PassChoice { All, OfInput, TraversalOnly, Pipeline };

/// The passes named on a command line, in the order of the command line.
class PassOptions {
public:
  /// Adds the options to `command`, which must outlive this.
  void declare(const CommandLine &command, PassChoice choice);

  /// The names as written; only after `command` has parsed. Unknown ones are left for `runPasses` to name.
  std::vector<std::string> names() const;

  /// True if the input has to tell how many bits short pointers have.
  bool asksPointerBits() const;

  /// The names with these bits for what the input has to tell; without that pass if there are none that do.
  std::vector<std::string> namesWith(std::optional<int> pointerBits) const;

  /// Runs the chosen passes on `format`; nothing is known of the input. Error `Usage`: a storage
  /// pass where only traversal passes apply.
  Expected<void> apply(Format &format, const PipelineOptions &options = {}) const;

private:
  std::optional<CommandLine> command_;
  PassChoice choice_ = PassChoice::All;
};

/// Options with which each pass that changes nothing is a note on standard error that says why, unless quiet.
PipelineOptions tellingMissed(bool quiet);

} // namespace voxc::tool
