// Building volumes: generated construction code, compiled in this process and run on a source.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace voxc {

struct BuildOptions {
  std::string provenance; ///< Kept in the volume.
  Progress progress;
};

struct BuildReport {
  double seconds = 0;            ///< From the opened source to the finished words.
  std::uint64_t voxels = 0;      ///< Non-empty voxels.
  std::uint64_t uniqueNodes = 0; ///< Nodes of shared trees that were written.
  std::uint64_t sharedNodes = 0; ///< Times a node was found written already.
};

struct Built {
  Volume volume;
  BuildReport report;
};

/// Construction code of one format, compiled and callable.
class Constructor {
public:
  /// Emits construct.cpp for `format` (verified) and compiles it with Clang in this process.
  static Expected<Constructor> compile(const Format &format);
  ~Constructor();
  Constructor(Constructor &&) noexcept;

  /// Seconds from the text to callable code.
  double compileSeconds() const;

  /// Builds the volume of a source. Errors: the source is larger than the format or failed (its error), more
  /// than 2^32 words are needed (`Input`, naming the size reached), or the build was stopped.
  Expected<Built> build(VoxelSource &source, const BuildOptions &options = {}) const;

private:
  struct State;
  explicit Constructor(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc
