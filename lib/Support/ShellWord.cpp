// Quoting for shells.
#include "voxc/Support/ShellWord.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace voxc {
namespace {

bool isPlain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("-_.,:/=+@").find(c) != std::string_view::npos;
}

} // namespace

std::string shellWord(const std::string &word) {
  if (!word.empty() && std::ranges::all_of(word, isPlain))
    return word;
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

} // namespace voxc
