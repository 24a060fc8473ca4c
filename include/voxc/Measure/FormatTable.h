// Formats that suit a scene, with their sizes and speeds: what `voxc suggest` predicts of them, and what
// `voxc search` measures.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Trace/Ray.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// The speed of a format on a set of rays, in rays a second: of one core where a processor traces, of the
/// device else. What was not measured, or not predicted, is 0.
struct FormatSpeed {
  double predicted = 0;
  double measured = 0; ///< The median of several rounds, and the least and the most of them.
  double slowest = 0, fastest = 0;
  std::uint64_t checkedRays = 0; ///< Of which the oracle was asked,
  std::uint64_t wrongRays = 0;   ///< those with another hit,
  double maxUlp = 0;             ///< and how far t is from the exact one at most, in units of its last place.
};

struct FormatRow {
  std::string format;              ///< As `parseFormat` takes it,
  std::vector<std::string> passes; ///< with these passes, by name.
  std::uint64_t bytes = 0;         ///< Of its words.
  bool isExact = true;             ///< Not one more, not one less; what was measured is exact.
  bool isOnFrontier = false;       ///< No other row is as small and as fast, or better.
  bool isChosen = false;           ///< What the objective asks for.
  std::string failure;             ///< Of a search: why it has no speeds; "": it has.
  std::vector<FormatSpeed> speeds; ///< Of each set of rays.
};

struct FormatTable {
  std::uint64_t voxels = 0;      ///< Of the scene.
  std::vector<std::string> sets; ///< Names of the sets of rays.
  std::vector<FormatRow> rows;
};

/// What is asked of formats.
struct FormatQuestion {
  std::string objective = "balanced"; ///< Twice the speed is worth four times the bytes; "fastest" or
                                      ///< "smallest".
  std::uint64_t maxBytes = 0;         ///< Of a volume's words; 0: what references can reach.
  std::string device;                 ///< That will trace, as `TracerChoice::device`.
  std::string precision = "exact";    ///< Of a search: or "fast".
  std::vector<std::string> formats;   ///< Those to choose from; empty: those that voxc knows, and of a search
                                      ///< what it makes of them.
  std::vector<Ray> rays; ///< That will be traced, 8 at least; empty: those of a camera that sees everything,
                         ///< and rays from where they hit that go anywhere.
  bool editable = false; ///< Of a prediction: only formats whose volumes can be edited in place.
  double seconds = 180;  ///< That a search may take, below 1e9.
  unsigned threads = 0;  ///< That build, and of a device that is this processor; 0: all.
  std::shared_ptr<WorkingMemory> memory; ///< Null: as much as building takes by default.
  std::string name = "the scene";        ///< What errors call the scene.
};

/// Opens the voxels of a scene anew.
using SourceOpener = std::function<Expected<std::unique_ptr<VoxelSource>>()>;

/// Predicts what formats take and how fast they are, and builds none. The scene is read once, or twice where
/// its colours are more than the memory holds. Errors: those of the source; a scene without a voxel, a text
/// that is no format, no format that takes so few bytes (`Input`); another objective, fewer than 8 rays
/// (`Usage`); `Interrupted`.
Expected<FormatTable> suggestFormats(const SourceOpener &open, const FormatQuestion &question,
                                     const Progress &progress = {});

/// Builds and measures those formats that promise most, in a folder that is there for the while. What is
/// learned of the device is kept in the user's cache, for the next search and for predictions. Errors also:
/// the seconds are none, or too few for one format (`Usage`); there is no such device, or no memory for the
/// scene's colours (`Environment`).
Expected<FormatTable> searchFormats(const SourceOpener &open, const FormatQuestion &question,
                                    const Progress &progress = {});

} // namespace voxc
