// Files that are mapped for reading, privately: what is written to the memory is not written to the file.
#pragma once

#include <cstddef>
#include <span>

namespace voxc::platform {

/// The first `size` bytes of an open file, at least one; null with `errno` if that fails. The file may be
/// closed.
const std::byte *mapFile(int file, std::size_t size);
void unmapFile(std::span<const std::byte> mapped);

/// Lets pages of a mapped file, or of a scratch file, go out of this process; they come back when they are
/// read.
void letGo(std::span<const std::byte> mapped);

/// Makes the pages of such bytes, or of other memory of this process, writable. False with `errno` if that
/// fails.
bool makeWritable(std::span<const std::byte> bytes);

} // namespace voxc::platform
