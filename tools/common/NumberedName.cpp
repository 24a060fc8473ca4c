// Names of files that are numbered.
#include "NumberedName.h"

#include <algorithm>
#include <filesystem>

namespace voxc::tool {
namespace {

constexpr std::size_t kMostDigits = 9;

std::optional<NumberedPath> parseSigns(const std::string &text) {
  const std::size_t first = text.find('#');
  if (first == std::string::npos)
    return std::nullopt;
  const std::size_t end = std::min(text.find_first_not_of('#', first), text.size());
  if (text.find('#', end) != std::string::npos)
    return std::nullopt;
  return NumberedPath(text.substr(0, first), std::min(end - first, kMostDigits), text.substr(end));
}

} // namespace

// One % makes the place, if there is a right one; the # that stand beside it, in the name of a folder, are as
// they are.
std::optional<NumberedPath> parseNumberedName(const std::string &text) {
  std::optional<NumberedPath> name = NumberedPath::parse(text);
  return name ? name : parseSigns(text);
}

std::string stemOfNumbered(const std::string &path) {
  const std::optional<NumberedPath> name = NumberedPath::parse(path);
  if (!name)
    return std::filesystem::path(path).stem().string();
  const std::size_t last = name->before().find_last_not_of("-_. /");
  if (last != std::string::npos)
    return std::filesystem::path(name->before().substr(0, last + 1)).filename().string();
  const std::string stem = std::filesystem::path("n" + name->after()).stem().string();
  return stem.substr(std::min(stem.find_first_not_of("-_. ", 1), stem.size()));
}

std::string asPercent(const NumberedPath &name) {
  return name.before() + "%0" + std::to_string(name.digits()) + "d" + name.after();
}

} // namespace voxc::tool
