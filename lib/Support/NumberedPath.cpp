// Reading of patterns.
#include "voxc/Support/NumberedPath.h"

namespace voxc {

namespace {

/// A place for a number at the beginning of a text: how many characters it has, and digits.
struct Place {
  std::size_t size = 0; ///< 0: there is none.
  std::size_t digits = 1;
};

Place placeAt(std::string_view text) {
  if (text.starts_with("%d"))
    return {2, 1};
  const bool hasDigits = text.size() >= 4 && text.starts_with("%0") && text[2] >= '1' && text[2] <= '9';
  return hasDigits && text[3] == 'd' ? Place{4, static_cast<std::size_t>(text[2] - '0')} : Place{};
}

} // namespace

std::optional<NumberedPath> NumberedPath::parse(std::string_view text) {
  std::optional<NumberedPath> found;
  for (std::size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1)) {
    const Place place = placeAt(text.substr(at));
    if (place.size == 0)
      continue;
    if (found)
      return std::nullopt;
    found.emplace(std::string(text.substr(0, at)), place.digits, std::string(text.substr(at + place.size)));
  }
  return found;
}

std::string NumberedPath::operator()(std::uint64_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < digits_)
    digits.insert(0, digits_ - digits.size(), '0');
  return before_ + digits + after_;
}

} // namespace voxc
