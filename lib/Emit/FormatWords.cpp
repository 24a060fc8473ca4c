// Words of a text, one after the other.
#include "Emit/FormatWords.h"

#include <cctype>
#include <cstdio>

namespace voxc {
namespace {

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string replaced(std::string_view word, const FormatWords &words) {
  if (const auto found = words.find(word); found != words.end())
    return found->second;
  for (const auto &[begin, other] : words)
    if (begin.ends_with('_') && word.starts_with(begin))
      return other + std::string(word.substr(begin.size()));
  return std::string(word);
}

std::string halfOf(std::uint64_t number) {
  char digits[12];
  std::snprintf(digits, sizeof digits, "0x%08xu", static_cast<unsigned>(number));
  return digits;
}

} // namespace

std::string hexadecimal(std::uint64_t number) {
  char digits[19];
  std::snprintf(digits, sizeof digits, "0x%016llx", static_cast<unsigned long long>(number));
  return digits;
}

FormatWords formatWords(const Layout &layout) {
  const std::uint64_t digest = layout.storageDigest;
  return {{"FORMAT", layout.format},
          {"DIGEST", hexadecimal(digest)},
          {"DIGESTull", hexadecimal(digest) + "ull"},
          {"DIGEST_LOW", halfOf(digest)},
          {"DIGEST_HIGH", halfOf(digest >> 32)}};
}

std::string replaceWords(std::string_view text, const FormatWords &words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && isOfWord(text[end]))
      ++end;
    if (end > at) {
      result += replaced(text.substr(at, end - at), words);
      at = end;
    } else {
      result += text[at++];
    }
  }
  return result;
}

} // namespace voxc
