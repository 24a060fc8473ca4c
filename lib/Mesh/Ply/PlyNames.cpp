// Looking for names, and listing those that were not looked for.
#include "Mesh/Ply/PlyNames.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 7> kNormals{"nx",       "ny",       "nz",    "normal_x",
                                                   "normal_y", "normal_z", "normal"};
constexpr std::size_t kMostNames = 12;

void addName(std::string &list, std::size_t &count, const std::string &name) {
  if (count < kMostNames)
    list += (count == 0 ? "" : ", ") + name.substr(0, 40);
  ++count;
}

std::string finished(const std::string &list, std::size_t count) {
  return count > kMostNames ? list + " and " + std::to_string(count - kMostNames) + " more" : list;
}

} // namespace

std::optional<std::size_t> findNumber(const PlyElement &element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (!element.properties[i].countType && lowerCase(element.properties[i].name) == name)
      return i;
  return std::nullopt;
}

std::optional<std::size_t> findList(const PlyElement &element, std::span<const std::string_view> names) {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (element.properties[i].countType && lowerCase(element.properties[i].name) == name)
        return i;
  return std::nullopt;
}

std::string PlyUse::unusedOf(const PlyElement &element, const std::set<std::size_t> &used) const {
  std::string list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (!used.contains(i) &&
        std::ranges::find(kNormals, lowerCase(element.properties[i].name)) == kNormals.end())
      addName(list, count, element.properties[i].name);
  return finished(list, count);
}

std::vector<std::string> PlyUse::warnings() const {
  std::vector<std::string> sentences = header_.warnings;
  std::string others;
  std::size_t count = 0;
  for (const PlyElement &element : header_.elements) {
    const auto used = used_.find(&element);
    if (element.count == 0)
      continue;
    if (used == used_.end())
      addName(others, count, element.name);
    else if (const std::string unused = unusedOf(element, used->second); !unused.empty())
      sentences.push_back("of the element '" + element.name + "' these properties are not used: " + unused);
  }
  if (count != 0)
    sentences.push_back("these elements are not used: " + finished(others, count));
  return sentences;
}

} // namespace voxc
