// A .hvx file that is written while its words are made.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <span>
#include <string>

namespace voxc {

/// Lends the pages of the file to come as memory for the words: they stream to disk as they are written.
class VolumeFileWriter {
public:
  /// `info`: as it will be, but for the number of voxels. Errors: as `OutputFile::create`.
  static Expected<VolumeFileWriter> create(const std::string &path, const VolumeInfo &info);

  /// True if the file can lend its pages: it is not a pipe or a device.
  bool canExtend() const { return file_.isRegular(); }
  /// Adds at least `bytes` to the block in which the words lie. Error: `Environment`, a full disk.
  Expected<void> extend(MemoryBlock &block, std::uint64_t bytes, WorkingMemory &memory);

  /// Completes the file, whose words were all written to the block, and gives it its name.
  Expected<void> finish(const VolumeInfo &info, std::span<const std::uint32_t> words, WorkingMemory &memory);

private:
  VolumeFileWriter(OutputFile file, std::uint64_t wordsOffset)
      : file_(std::move(file)), wordsOffset_(wordsOffset) {}

  OutputFile file_;
  std::uint64_t wordsOffset_; ///< In bytes.
};

} // namespace voxc
