// What the head of a .hvx file says, without the streams behind it.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

/// One stream, as the file's table has it.
struct StreamSummary {
  std::string name;               ///< As `Stream::name`.
  std::uint32_t elementBytes = 1; ///< 1 to 256.
  std::uint64_t bytes = 0;        ///< As loaded.
  std::uint64_t storedBytes = 0;  ///< In the file.
  std::uint32_t pageBytes = 0;    ///< Of each page but the last, decoded; 0: it is stored as it is.

  std::uint64_t elements() const { return bytes / elementBytes; }
  /// How many pages it is stored in; 0 if it is stored as it is.
  std::uint64_t pages() const { return pageBytes ? bytes / pageBytes + (bytes % pageBytes != 0) : 0; }
};

struct VolumeSummary {
  VolumeInfo info;
  std::vector<StreamSummary> streams; ///< In the order of the file; the first is `words`.

  /// Of all streams together, as loaded.
  std::uint64_t bytes() const;
  /// The same in the file.
  std::uint64_t storedBytes() const;
};

/// Reads the head of a file in time that does not follow its size. Sizes are held against the file's, and a
/// compressed file's head against its checksum; that a plain file is whole, and that its words are those of a
/// volume, `Volume::load` proves. Errors (`Input`): no such file, not a .hvx, cut short, a head that
/// contradicts itself.
Expected<VolumeSummary> summarizeVolume(const std::string &path);

} // namespace voxc
