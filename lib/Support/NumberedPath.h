// Paths of files that are numbered, as in slice%04d.png.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// A path with one %d, or %01d to %09d, in place of a number from 0 on.
class NumberedPath {
public:
  /// Nothing if the text has no such place, or two.
  static std::optional<NumberedPath> parse(std::string_view text);

  /// The path of a number: at least as many digits as the pattern says.
  std::string operator()(std::uint64_t number) const;

private:
  std::string before_;
  std::string after_;
  std::size_t digits_ = 1;
};

} // namespace voxc
