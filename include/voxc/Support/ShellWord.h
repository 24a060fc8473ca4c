// Words of a command as a shell takes them.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace voxc {

/// The word as it is, or in single quotes if a shell would take it for something else.
inline std::string shellWord(std::string_view word) {
  bool isPlain = !word.empty();
  std::string quoted = "'";
  for (const char c : word) {
    isPlain &= std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("-_.,:/=+@").find(c) != std::string_view::npos;
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return isPlain ? std::string(word) : quoted + "'";
}

} // namespace voxc
