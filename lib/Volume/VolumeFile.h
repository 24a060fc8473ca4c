// The .hvx file (docs/hvx.md): a header that says everything about the words, then the words.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace voxc {

/// Where the words of a checked file lie.
struct VolumeFileContents {
  VolumeInfo info;
  std::span<const std::uint32_t> words; ///< Inside the bytes that were parsed.
};

/// Parses a whole file that lies in memory, aligned to 4 bytes. Nothing that it claims is believed: sizes are
/// held against the file's own, the checksum against all its bytes.
Expected<VolumeFileContents> parseVolumeFile(std::span<const std::byte> bytes, const std::string &name);

/// Where the words of a file with this header begin, in bytes: a whole page.
std::uint64_t volumeWordsOffset(const VolumeInfo &info);

/// The header of a file that holds these words, padded so that the words that follow are aligned to a page.
/// `pause` is called for every few kilobytes of words that are read.
std::string volumeFileHeader(const VolumeInfo &info, std::span<const std::uint32_t> words,
                             const std::function<void()> &pause = {});

} // namespace voxc
