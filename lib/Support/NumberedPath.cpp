// Reading of patterns.
#include "voxc/Support/NumberedPath.h"

namespace voxc {

std::optional<NumberedPath> NumberedPath::parse(std::string_view text) {
  const std::size_t at = text.find('%');
  if (at == std::string_view::npos || text.find('%', at + 1) != std::string_view::npos)
    return std::nullopt;
  std::size_t digits = 1;
  std::string_view rest = text.substr(at + 1);
  if (rest.size() > 1 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9') {
    digits = static_cast<std::size_t>(rest[1] - '0');
    rest.remove_prefix(2);
  }
  if (!rest.starts_with('d'))
    return std::nullopt;
  return NumberedPath(std::string(text.substr(0, at)), digits, std::string(rest.substr(1)));
}

std::string NumberedPath::operator()(std::uint64_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < digits_)
    digits.insert(0, digits_ - digits.size(), '0');
  return before_ + digits + after_;
}

} // namespace voxc
