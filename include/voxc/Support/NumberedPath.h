// Paths of files that are numbered, as in slice%04d.png.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace voxc {

/// A path with one %d, or %01d to %09d, in place of a number from 0 on.
class NumberedPath {
public:
  /// A number of at least so many digits between two texts, which are as they are.
  NumberedPath(std::string before, std::size_t digits, std::string after)
      : before_(std::move(before)), after_(std::move(after)), digits_(digits) {}

  /// Nothing if the text has no such place, or two; any other % is as it is.
  static std::optional<NumberedPath> parse(std::string_view text);

  /// The path of a number: at least as many digits as the pattern says.
  std::string operator()(std::uint64_t number) const;

  const std::string &before() const { return before_; }
  const std::string &after() const { return after_; }
  std::size_t digits() const { return digits_; }

private:
  std::string before_;
  std::string after_;
  std::size_t digits_;
};

} // namespace voxc
