// Whole volumes from compressed .hvx files.
#pragma once

#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc {

/// Decodes the streams of a file, which `name` calls, into memory that grows with what was decoded, whatever
/// the file claims. Pages of zeros take next to nothing in a file, so a stream is decoded only where it stays
/// below a multiple of what it takes there, or its volume has the voxels for it, which are proved first.
class PagedReading {
public:
  PagedReading(const PagedVolume &file, const std::string &name, const LoadOptions &options);

  /// What has to be proved: the words, and the frames in them. Errors: a damaged page, or a stream of more
  /// than there can be; `Environment`, no memory.
  Expected<Volume> proved() const;
  /// The whole volume, of what `proved` has given. Errors: the same.
  Expected<Volume> whole(Volume proved) const;

private:
  const PagedVolume &file_;
  const std::string &name_;
  LoadOptions options_; ///< Always with a memory.
};

} // namespace voxc
