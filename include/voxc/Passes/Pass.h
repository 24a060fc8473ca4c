// Passes over the level IR, registered by name in one table (lib/Passes/PassRegistry.cpp): choices, which set
// an attribute, and rewrites, which make other levels.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/PassManager.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

enum class PassResult { Changed, Unchanged };

/// The number that a pass takes, as in `--palette=4` or, in a pipeline, `palette{bits=4}`.
struct PassNumber {
  std::string_view name; ///< "bits".
  int least;
  int most;
  int byDefault; ///< What a pass without one takes.
};

/// What a choice is set on: the format, or those of these levels that take it.
enum class ChoiceScope {
  Format,
  Levels,
  LowerLevels, ///< All but the first.
  LastLevel,
  Trees ///< Trees of more than one cell.
};

/// What becomes of a choice that its format cannot have.
enum class Unfit {
  LeftOut, ///< The format stays as it is, and a note says why.
  Error
};

/// The attribute that a pass sets.
struct AttributeChoice {
  const AttributeKind *kind = nullptr;
  std::string_view value; ///< `#` in it stands for the pass's number.
  ChoiceScope scope = ChoiceScope::Format;
  Unfit unfit = Unfit::Error;
  const AttributeKind *implied = nullptr; ///< Set on the format too, to its second value; or null.

  /// The value with a number in its place.
  std::string valueWith(int number) const;
};

/// A pass: its name is also its flag (`--whole-level-dedup`).
struct Pass {
  std::string_view name;
  AttributeEffect effect; ///< Traversal passes may be applied to any volume.
  std::string_view summary;
  std::string_view details; ///< A paragraph for `voxc-opt --help-passes` and docs/passes.md.
  AttributeChoice choice;   ///< Without a kind where `function` does the work.
  PassResult (*function)(Format &format, Diagnostics &diagnostics) = nullptr;
  std::optional<PassNumber> number; ///< Nothing: it takes none.
  bool rewrites = false;            ///< It makes other levels, or removes attributes; else it is a choice.
  /// What makes short pointers smaller in every scene: tools that choose these choose it too.
  bool besidePointers = false;

  /// Runs it, with its default number or another in its range. Notes say why a format stays as it is; errors
  /// what would be wrong, and the format then stays as it is.
  PassResult run(Format &format, Diagnostics &diagnostics, std::optional<int> with = std::nullopt) const;
};

/// All passes, in the order in which choices are resolved, which is that of the documentation.
std::span<const Pass> passes();

/// The pass of this name, which may have a number ("palette=4", "palette{bits=4}"), or null.
const Pass *findPass(std::string_view name);

enum class PassOrder {
  Resolved, ///< Rewrites as they are written, then choices as the table has them: their order means nothing.
  AsWritten
};

/// Runs passes by name: "palette", "palette=4" or "palette{bits=4}". Errors: an unknown pass (naming those
/// there are), a wrong number, two values of one attribute. A pass that does not apply without being wrong
/// leaves the format unchanged; one that would be wrong is an error.
Expected<void> runPasses(Format &format, std::span<const std::string> names,
                         const PipelineOptions &options = {}, PassOrder order = PassOrder::Resolved);

/// A pass as a pipeline's text has it, with its number: "palette{bits=8}". Errors as of `runPasses`.
Expected<std::string> passText(const std::string &name);

// What passes that are more than a choice promise stands in their own files of lib/Passes.
PassResult granules(Format &format, Diagnostics &diagnostics);
PassResult mergeGrids(Format &format, Diagnostics &diagnostics);
PassResult splitGrids(Format &format, Diagnostics &diagnostics);
PassResult sharedStack(Format &format, Diagnostics &diagnostics);
PassResult stripTraversal(Format &format, Diagnostics &diagnostics);

} // namespace voxc
