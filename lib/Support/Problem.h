// The first thing that a reader found wrong.
#pragma once

#include "voxc/Support/Error.h"

#include <optional>
#include <string>
#include <utility>

namespace voxc {

/// Keeps the first problem. Readers go on with harmless values and look here in the end.
class Problem {
public:
  void set(std::string what) { set(Error::input(std::move(what))); }
  void set(Error error) {
    if (!error_)
      error_ = std::move(error);
  }
  /// Takes over an error, if there is one.
  void check(const Expected<void> &result) {
    if (!result)
      set(result.error());
  }

  explicit operator bool() const { return error_.has_value(); }
  const Error &error() const { return *error_; }

private:
  std::optional<Error> error_;
};

} // namespace voxc
