// Digests of texts and files, by which a build plan knows what it was made of.
#pragma once

#include "voxc/Support/Error.h"

#include <memory>
#include <string>
#include <string_view>

namespace voxc::tool::cluster {

/// XXH3 of 64 bits over parts, each with its length, so that ("ab", "c") is not ("a", "bc").
class TextDigest {
public:
  TextDigest();
  ~TextDigest();
  TextDigest(const TextDigest &) = delete;
  TextDigest &operator=(const TextDigest &) = delete;

  TextDigest &add(std::string_view part);
  /// The content of a file. Error: `Input` if it cannot be read.
  Expected<void> addFile(const std::string &path);
  /// 16 hex digits.
  std::string hex() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace voxc::tool::cluster
