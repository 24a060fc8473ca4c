// A .hvx file that is written while its words are made.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <span>
#include <string>

namespace voxc {

/// Takes complete pages of words as they are made; the rest follows at the end.
class VolumeFileWriter {
public:
  /// `info`: as it will be, but for the number of voxels. Errors: as `OutputFile::create`.
  static Expected<VolumeFileWriter> create(const std::string &path, const VolumeInfo &info);

  /// True if words can be settled: the file is not a pipe or a device.
  bool canSettle() const { return file_.isRegular(); }
  /// Writes pages of the block in which the words lie, and maps them from the file. Error: `Environment`, a
  /// full disk.
  Expected<void> settle(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes, WorkingMemory &memory);

  /// Completes the file and gives it its name. Bytes [settled.first, settled.second) of the words are there.
  Expected<void> finish(const VolumeInfo &info, std::span<const std::uint32_t> words,
                        std::pair<std::uint64_t, std::uint64_t> settled, WorkingMemory &memory);

private:
  VolumeFileWriter(OutputFile file, std::uint64_t wordsOffset)
      : file_(std::move(file)), wordsOffset_(wordsOffset) {}

  OutputFile file_;
  std::uint64_t wordsOffset_; ///< In bytes.
};

} // namespace voxc
