// Instantiation of runtime files for levels.
#include "RuntimeFile.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace voxc {
namespace {

bool isIdentifier(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string count(int log2, std::string_view unit) {
  const std::int64_t number = std::int64_t{1} << log2;
  return std::to_string(number) + " " + std::string(unit) + (number == 1 ? "" : "s");
}

using Words = std::map<std::string_view, std::string>;

Words wordsOf(const Plan &plan, const LevelPlan &level) {
  const bool last = level.number == static_cast<int>(plan.levels.size());
  return {{"N", std::to_string(level.number)},
          {"NEXT", last ? "voxel" : "level_" + std::to_string(level.number + 1)},
          {"KIND", std::string(level.kind->name)}};
}

std::string replaceWords(std::string_view text, const Words &words) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    // An underscore separates words too, so that LEVEL_N_DEPTH is LEVEL, N and DEPTH.
    std::size_t end = begin;
    while (end < text.size() && isIdentifier(text[end]))
      ++end;
    const std::string_view word = text.substr(begin, end - begin);
    const auto found = words.find(word);
    result += found == words.end() ? word : found->second;
    if (end < text.size())
      result += text[end];
    begin = end + 1;
  }
  return result;
}

} // namespace

std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path) {
  const auto found = std::ranges::find(files, path, &EmbeddedFile::path);
  assert(found != files.end() && "a runtime file that a table row names is not embedded");
  return found->text;
}

std::string instantiate(std::string_view text, const Plan &plan, const LevelPlan &level) {
  return replaceWords(text, wordsOf(plan, level));
}

std::string instantiate(std::string_view text, const Plan &plan, const LevelPlan &level, int height) {
  const std::string number = "level_" + std::to_string(level.number);
  const auto node = [&](int side) {
    return side == level.log2Size.x ? number : number + "_height_" + std::to_string(side);
  };
  Words words = wordsOf(plan, level);
  words["H"] = std::to_string(height);
  words["NODE"] = node(height);
  words["CHILD"] = node(height - 1);
  return replaceWords(text, words);
}

std::string resolveConditions(std::string_view text, std::string_view name, bool defined) {
  const std::string condition = "#ifdef " + std::string(name) + "\n";
  std::string result;
  bool isOurs = false, applies = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view line = text.substr(begin, end - begin);
    begin = end;
    if (line == condition)
      isOurs = true, applies = defined;
    else if (isOurs && line.starts_with("#else"))
      applies = !applies;
    else if (isOurs && line.starts_with("#endif"))
      isOurs = false, applies = true;
    else if (applies)
      result += line;
  }
  return result;
}

std::string levelComment(const LevelPlan &level) {
  const Int3 size = level.log2Size;
  std::string text =
      "\n// Level " + std::to_string(level.number) + ": " + std::string(level.kind->name) + ", ";
  text += std::to_string(1 << size.x) + " x " + std::to_string(1 << size.y) + " x " + count(size.z, "cell");
  return text + " of " + count(level.log2CellSide, "voxel") + " a side.\n";
}

} // namespace voxc
