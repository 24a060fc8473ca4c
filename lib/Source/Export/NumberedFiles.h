// A set of numbered files that a reader finds only when it is whole.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/NumberedPath.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Files of a pattern, numbered from 0 on. Who reads such a set begins with number 0, or with 1 where there
/// is none: these two get their names last, so that however the work ends before, the set has no beginning.
/// What an earlier set has under their names is removed when the first of its other files is replaced, not
/// before.
class NumberedFiles {
public:
  explicit NumberedFiles(const NumberedPath &path) : path_(path) {}

  /// Writes the next file. Errors: as `writeFile`.
  Expected<void> add(std::string_view bytes);
  /// Gives the first ones their names. Errors: as `OutputFile::commit`.
  Expected<void> finish();

  std::uint64_t count() const { return count_; }
  /// A warning if an earlier, longer set has files behind the last of these: a reader would go on with them.
  /// "" if there are none.
  std::string leftover() const;

private:
  Expected<void> addBeginning(std::string_view bytes);

  NumberedPath path_;
  std::vector<OutputFile> beginning_; ///< Without names so far.
  std::uint64_t count_ = 0;
};

} // namespace voxc
