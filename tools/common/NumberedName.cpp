// Names of files that are numbered.
#include "NumberedName.h"

#include <algorithm>
#include <filesystem>

namespace voxc::tool {
namespace {

constexpr std::size_t kMostDigits = 9;

} // namespace

// One % makes the place, if there is a right one; the # that stand beside it, in the name of a folder, are as
// they are.
std::optional<NumberedName> NumberedName::parse(const std::string &text) {
  std::optional<NumberedName> name = parsePercent(text);
  return name ? name : parseSigns(text);
}

std::string NumberedName::stemOf(const std::string &path) {
  const std::optional<NumberedName> name = parsePercent(path);
  if (!name)
    return std::filesystem::path(path).stem().string();
  const std::size_t last = name->before_.find_last_not_of("-_. /");
  if (last != std::string::npos)
    return std::filesystem::path(name->before_.substr(0, last + 1)).filename().string();
  const std::string stem = std::filesystem::path("n" + name->after_).stem().string();
  return stem.substr(std::min(stem.find_first_not_of("-_. ", 1), stem.size()));
}

std::optional<NumberedName> NumberedName::parsePercent(const std::string &text) {
  const std::size_t first = text.find('%');
  if (first == std::string::npos || text.find('%', first + 1) != std::string::npos)
    return std::nullopt;
  NumberedName name;
  std::size_t end = first + 1;
  if (end + 1 < text.size() && text[end] == '0' && text[end + 1] >= '1' && text[end + 1] <= '9') {
    name.digits_ = std::size_t(text[end + 1] - '0');
    end += 2;
  }
  if (end >= text.size() || text[end] != 'd')
    return std::nullopt;
  name.before_ = text.substr(0, first);
  name.after_ = text.substr(end + 1);
  return name;
}

std::optional<NumberedName> NumberedName::parseSigns(const std::string &text) {
  const std::size_t first = text.find('#');
  if (first == std::string::npos)
    return std::nullopt;
  const std::size_t end = std::min(text.find_first_not_of('#', first), text.size());
  if (text.find('#', end) != std::string::npos)
    return std::nullopt;
  NumberedName name;
  name.before_ = text.substr(0, first);
  name.digits_ = std::min(end - first, kMostDigits);
  name.after_ = text.substr(end);
  return name;
}

std::string NumberedName::operator()(std::uint64_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < digits_)
    digits.insert(0, digits_ - digits.size(), '0');
  return before_ + digits + after_;
}

std::string NumberedName::asPercent() const {
  return before_ + "%0" + std::to_string(digits_) + "d" + after_;
}

} // namespace voxc::tool
