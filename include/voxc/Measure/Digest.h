// A digest of texts and files: what cells and cached volumes are known by.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace voxc::measure {

/// FNV-1a of 64 bits over parts, each with its length, so that ("ab", "c") is not ("a", "bc"). It
/// differs where contents do by chance; it is no defence against someone who wants them to collide.
class Digest {
public:
  Digest &add(std::string_view part);
  /// The content of a file. Error: `Input` if it cannot be read.
  Expected<void> addFile(const std::string &path);
  /// 16 hex digits.
  std::string hex() const;

private:
  void addBytes(std::string_view bytes);

  std::uint64_t state_ = 0xcbf29ce484222325;
};

} // namespace voxc::measure
