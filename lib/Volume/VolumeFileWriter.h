// A .hvx file that is written while its words are made.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace voxc {

/// Takes complete pages of words as they are made; the rest, and all other streams, follow at the end.
class VolumeFileWriter {
public:
  /// `info`: as it will be, but for the number of voxels. `streams`: how many there will be. `path` is that
  /// of a regular file, or will be. Errors: as `OutputFile::create`.
  static Expected<VolumeFileWriter> create(const std::string &path, const VolumeInfo &info,
                                           std::size_t streams = 1);

  /// Writes pages of the block in which the words lie, and maps them from the file. Error: `Environment`, a
  /// full disk.
  Expected<void> flush(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes, WorkingMemory &memory);

  /// Completes the file and gives it its name. Bytes [flushed.first, flushed.second) of the words, the first
  /// stream, are there.
  Expected<void> finish(const VolumeInfo &info, std::span<const Stream> streams,
                        std::pair<std::uint64_t, std::uint64_t> flushed, WorkingMemory &memory);

private:
  VolumeFileWriter(std::string path, OutputFile file, std::uint64_t wordsOffset)
      : path_(std::move(path)), file_(std::move(file)), wordsOffset_(wordsOffset) {}
  Expected<void> write(std::uint64_t offset, std::span<const std::byte> bytes, WorkingMemory &memory);

  std::string path_;
  OutputFile file_;
  std::uint64_t wordsOffset_; ///< In bytes.
};

} // namespace voxc
