// Passes over the level IR: free functions, registered by name in one table (lib/Passes/PassRegistry.cpp).
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/Diagnostic.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

enum class PassResult { Changed, Unchanged };

/// The number that a pass takes, as in `--palette=4`.
struct PassNumber {
  int least;
  int most;
  int usual; ///< What a pass without one takes.
  PassResult (*run)(Format &format, int number, Diagnostics &diagnostics);
};

/// A pass: its name is also its flag (`--whole-level-dedup`).
struct Pass {
  std::string_view name;
  AttributeEffect effect; ///< Walk passes may be applied to any volume.
  std::string_view summary;
  std::string_view details; ///< A paragraph for `voxc-opt --help-passes` and docs/passes.md.
  PassResult (*run)(Format &format, Diagnostics &diagnostics);
  const PassNumber *number = nullptr; ///< Null: it takes none.
};

/// All passes, in the order of the documentation.
std::span<const Pass> passes();

/// The pass of this name, which may have a number ("palette=4"), or null.
const Pass *findPass(std::string_view name);

struct PipelineOptions {
  bool verifyEach = true;
  /// Called after each pass with the format as it then is, the result, and the seconds it took.
  std::function<void(const Pass &, const Format &, PassResult, double seconds)> afterEach;
};

/// Runs passes by name, in order. Errors: an unknown pass (naming those there are), a wrong number; a pass
/// that does not apply without being wrong leaves the format unchanged; one that would be wrong is an error.
Expected<void> runPasses(Format &format, std::span<const std::string> names,
                         const PipelineOptions &options = {});

// What each pass promises stands in its own file of lib/Passes.
PassResult wholeLevelDedup(Format &format, Diagnostics &diagnostics);
PassResult shareGrids(Format &format, Diagnostics &diagnostics);
PassResult visibleVoxels(Format &format, Diagnostics &diagnostics);
PassResult occupancy(Format &format, Diagnostics &diagnostics);
PassResult constantColour(Format &format, Diagnostics &diagnostics);
PassResult palette(Format &format, Diagnostics &diagnostics);
PassResult paletteOf(Format &format, int log2Colours, Diagnostics &diagnostics);
PassResult rgb565(Format &format, Diagnostics &diagnostics);
PassResult material(Format &format, Diagnostics &diagnostics);
PassResult materialOf(Format &format, int bits, Diagnostics &diagnostics);
PassResult valuesApart(Format &format, Diagnostics &diagnostics);
PassResult shortPointers(Format &format, Diagnostics &diagnostics);
PassResult granules(Format &format, Diagnostics &diagnostics);
PassResult shortPointersOf(Format &format, int bits, Diagnostics &diagnostics);
PassResult octantCounts(Format &format, Diagnostics &diagnostics);
PassResult octantMasks(Format &format, Diagnostics &diagnostics);
PassResult inlineLeaves(Format &format, Diagnostics &diagnostics);
PassResult octantDistances(Format &format, Diagnostics &diagnostics);
PassResult dfPacking(Format &format, Diagnostics &diagnostics);
PassResult mergeGrids(Format &format, Diagnostics &diagnostics);
PassResult splitGrids(Format &format, Diagnostics &diagnostics);
PassResult restartSv(Format &format, Diagnostics &diagnostics);
PassResult unrollSv(Format &format, Diagnostics &diagnostics);
PassResult flatWalk(Format &format, Diagnostics &diagnostics);
PassResult directWalk(Format &format, Diagnostics &diagnostics);
PassResult sharedStack(Format &format, Diagnostics &diagnostics);
PassResult stripWalk(Format &format, Diagnostics &diagnostics);

} // namespace voxc
