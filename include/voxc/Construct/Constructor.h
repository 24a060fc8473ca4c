// Building volumes: generated construction code, compiled in this process and run on a source.
#pragma once

#include "voxc/Construct/FragmentShare.h"
#include "voxc/IR/Format.h"
#include "voxc/Source/Edit.h"
#include "voxc/Source/Rounding.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voxc {

/// How to build. Nothing of it changes a byte of the volume, if there is one; `compress` changes those of its
/// file.
struct BuildOptions {
  std::string provenance; ///< Kept in the volume.
  unsigned threads = 1;   ///< Sources that have but one reader are built on one.
  /// The bound on the memory, also of the source if it was opened with the same; null: the default one.
  std::shared_ptr<WorkingMemory> memory;
  /// Where the volume is written while it is built, under a temporary name until it is whole; "": the words
  /// stay in memory, or in the scratch file.
  std::string path;
  Progress progress;
  /// Compresses the file when the volume is whole; until then its words lie beside it as they are, in
  /// a file without a final name.
  bool compress = false;
  /// A volume of more is an error, and one of more than its references can reach in any case.
  std::uint64_t maxWords = std::numeric_limits<std::uint64_t>::max();
};

/// What became of one level.
struct LevelReport {
  std::uint64_t words = 0;
  std::uint64_t uniqueNodes = 0; ///< Grids, nodes, blocks of siblings and shared leaves that were written.
  std::uint64_t sharedNodes = 0; ///< References to one that another leads to already.
};

struct BuildReport {
  double seconds = 0;      ///< From the opened source to the finished volume.
  double cpuSeconds = 0;   ///< The same in seconds of computing, of all threads of the process.
  double readSeconds = 0;  ///< Of computing, over all threads, that made voxels.
  double writeSeconds = 0; ///< For what is left to do with the file when the words are complete.
  std::uint64_t voxels = 0;
  std::uint64_t scratchBytes = 0; ///< Largest size of the scratch file.
  std::vector<LevelReport> levels;
  std::uint64_t valueWords = 0; ///< Of values that stand apart.
  /// Of payloads that round colours, but not of `merge`; of an edit over the parts that it built anew.
  std::optional<ColourError> colourError;
};

class FragmentSet;

struct Built {
  Volume volume;
  BuildReport report;
};

/// A volume that was built; or why it was not, and how many words there were by then.
class [[nodiscard]] BuildResult : public Expected<Built> {
public:
  BuildResult(Built built) : Expected<Built>(std::move(built)) {}
  /// An error before the first word.
  BuildResult(Error error) : Expected<Built>(std::move(error)) {}
  BuildResult(Expected<Built> built, std::uint64_t wordsReached)
      : Expected<Built>(std::move(built)), wordsReached_(wordsReached) {}

  /// Words of the volume when it was complete, or when building it failed.
  std::uint64_t wordsReached() const { return wordsReached_; }

private:
  std::uint64_t wordsReached_ = 0;
};

/// The aligned cubes of voxels in which a volume can be cut apart, numbered in Morton order.
struct PartNumbers {
  int log2Side = 0; ///< Of a cube.
  std::uint64_t count = 0;
};

/// How volumes of a source in a format can be cut.
PartNumbers partNumbersOf(const VoxelSource &source, const Format &format);

/// Construction code of one format, compiled and callable.
class Constructor {
public:
  /// Emits construct.cpp for `format` (verified) and compiles it with Clang in this process, or finds it in
  /// `cache`.
  static Expected<Constructor> compile(const Format &format, const CompileCache *cache = nullptr);
  ~Constructor();
  Constructor(Constructor &&) noexcept;

  /// Seconds from the text to callable code.
  double compileSeconds() const;

  /// Builds the volume of a source. The bytes depend on format and voxels alone. Errors: the source is larger
  /// than the format or failed (its error), more than `maxWords` words are needed (`Input`, naming
  /// the size reached), memory or disk is full, or the build was stopped.
  BuildResult build(VoxelSource &source, const BuildOptions &options = {}) const;

  /// Builds what `volume`, which is of the same format, becomes by the edits, one after the other: the words
  /// are those of a build of the edited voxels. What edits do not touch is neither decoded nor built, but the
  /// words are proved as a loader does. Errors: another format, an edit that reaches out of the volume, a
  /// volume whose words are shared in a way that no build shares them (`Input`); as `build`.
  BuildResult edit(const std::shared_ptr<const Volume> &volume, const std::vector<VoxelEdit> &edits,
                   const BuildOptions &options = {}) const;

  /// Builds the parts of a volume whose numbers, in Morton order, lie in the fragment `index` of `count` (0
  /// to count - 1), and writes them to `path` for `merge`. The report's levels say nothing. Errors: as
  /// `build`.
  Expected<BuildReport> buildFragment(VoxelSource &source, std::uint64_t index, std::uint64_t count,
                                      const std::string &path, const BuildOptions &options = {}) const;

  /// The same for the cubes [share.begin, share.end).
  Expected<BuildReport> buildFragment(VoxelSource &source, const FragmentShare &share,
                                      const std::string &path, const BuildOptions &options = {}) const;

  /// Joins fragments that follow one another to one, which holds all cubes of theirs: `merge` makes the same
  /// volume of it as of them. Errors: as `merge`; their cubes are not those of the share.
  Expected<BuildReport> joinFragments(const std::vector<std::string> &paths, const FragmentShare &share,
                                      const std::string &path, const BuildOptions &options = {}) const;

  /// Joins all fragments of a volume, given in any order, to what `build` makes of it. The provenance is
  /// theirs. Errors (`Input`): a file that is no fragment, is not whole or broken, of another format or
  /// input, or missing; fragments whose shares leave cubes of the volume out, or have some twice.
  BuildResult merge(const std::vector<std::string> &paths, const BuildOptions &options = {}) const;

  /// The same of some fragments that follow one another: a volume that holds their voxels alone. Errors: the
  /// same, but for those that are missing.
  BuildResult mergeRun(const std::vector<std::string> &paths, const BuildOptions &options = {}) const;

private:
  struct State;
  BuildResult buildVoxels(VoxelSource &source, const BuildOptions &options) const;
  Expected<void> checkFormat(const FragmentSet &fragments) const;
  BuildResult mergeOpened(Expected<FragmentSet> fragments, const BuildOptions &options) const;
  explicit Constructor(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Which fragment a file is and what it holds, once its checksum is found to be that of its bytes. Errors as
/// `merge`.
Expected<FragmentShare> checkFragment(const std::string &path);

/// The format of the volume that a fragment file belongs to. Errors as `merge`.
Expected<Format> formatOfFragment(const std::string &path);

} // namespace voxc
