// Names of files that are numbered: slice-###.png, or slice-%03d.png.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace voxc::tool {

/// A name with one place for a number: some # for as many digits, or %d, or %01d to %09d.
class NumberedName {
public:
  /// Nothing if the text has no such place, or two.
  static std::optional<NumberedName> parse(const std::string &text);

  /// What the files of a path with %d or %03d are called: "slice" of slice-%03d.png, "ct" of ct/%d.png; may
  /// be empty. Of a path without such a place its stem.
  static std::string stemOf(const std::string &path);

  /// The name of a number, with zeros in front to fill the place.
  std::string operator()(std::uint64_t number) const;
  /// The same pattern with %03d for three digits; the digits of more than nine # are nine.
  std::string asPercent() const;

private:
  static std::optional<NumberedName> parsePercent(const std::string &text);
  static std::optional<NumberedName> parseSigns(const std::string &text);

  std::string before_, after_;
  std::size_t digits_ = 1;
};

} // namespace voxc::tool
