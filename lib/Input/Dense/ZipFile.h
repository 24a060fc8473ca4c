// The files inside a ZIP archive, as NumPy writes them: stored or deflated.
#pragma once

#include "Input/Dense/ByteStream.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc {

struct ZippedFile {
  std::string name;
  std::span<const std::byte> stored;
  bool isDeflated = false;

  /// Its bytes; those of the archive must outlive the stream.
  std::unique_ptr<ByteStream> open() const;
};

/// All files of an archive by its directory, those that are encrypted or packed in another way left out.
/// Error: no archive, or one whose directory leads out of it.
Expected<std::vector<ZippedFile>> listZip(std::span<const std::byte> bytes);

} // namespace voxc
