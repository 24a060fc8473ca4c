// Filling holes.
#include "page/Holes.h"

namespace voxc::page {

Expected<std::string> fill(std::string_view text, const Holes &holes) {
  constexpr std::string_view kBegin = "${";
  std::string filled;
  for (;;) {
    const std::size_t begin = text.find(kBegin);
    filled += text.substr(0, begin);
    if (begin == std::string_view::npos)
      return filled;
    const std::size_t end = text.find('}', begin);
    const std::string_view name = text.substr(begin + kBegin.size(), end - begin - kBegin.size());
    const auto hole = holes.find(name);
    if (end == std::string_view::npos || hole == holes.end())
      return Error::input("there is no hole '" + std::string(name) + "'");
    filled += hole->second;
    text.remove_prefix(end + 1);
  }
}

} // namespace voxc::page
