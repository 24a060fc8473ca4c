// The list of Construct/Golden/words.txt, line by line: formats, scenes, and what words their volumes have.
#pragma once

#include "testing/HardScenes.h"

#include "voxc/IR/Format.h"
#include "voxc/Input/Input.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/File.h"

#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::test {

inline constexpr const char *kGoldenWords = VOXC_UNITTESTS_DIR "/Construct/Golden/words.txt";

/// A volume of the list, and what is known of its words.
struct Golden {
  std::string digest;
  std::uint64_t words = 0;
  std::string scene;
  std::string passes; ///< With commas between them, or "-".
  std::string format;
};

/// A line that is no comment.
inline std::optional<Golden> parseGolden(const std::string &line) {
  Golden golden;
  std::istringstream fields(line);
  if (line.starts_with('#') || !(fields >> golden.digest))
    return std::nullopt;
  fields >> golden.words >> golden.scene >> golden.passes >> std::ws;
  std::getline(fields, golden.format);
  return golden;
}

inline std::vector<std::string> linesOf(const std::string &path) {
  std::vector<std::string> lines;
  const auto text = readTextFile(path);
  std::istringstream stream(text ? *text : "");
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

inline Expected<Format> formatOf(const Golden &golden) {
  auto format = parseFormat(golden.format);
  if (!format || golden.passes == "-")
    return format;
  std::vector<std::string> names;
  std::istringstream passes(golden.passes);
  for (std::string name; std::getline(passes, name, ',');)
    names.push_back(name);
  if (auto run = runPasses(*format, names); !run)
    return run.error();
  return format;
}

inline Expected<std::unique_ptr<VoxelSource>> openScene(const std::string &name, Int3 extent) {
  constexpr std::string_view kHard = "hard:";
  if (!name.starts_with(kHard)) {
    auto input = openInput(name, {.formatExtent = extent});
    if (!input)
      return input.error();
    return std::move(input->source);
  }
  for (const HardScene &scene : hardScenes(extent))
    if (scene.name == name.substr(kHard.size()))
      return scene.source();
  return Error::input("there is no scene '" + name + "'");
}

} // namespace voxc::test
