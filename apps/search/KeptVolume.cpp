// Volumes that a search has built and keeps.
#include "search/KeptVolume.h"

#include "common/Files.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace voxc::tool {
namespace {

/// True if the figures have all that `addVolume` takes: anything may stand in a file.
bool areWhole(const Json &figures) {
  const auto has = [&](const char *key, bool (Json::*is)() const noexcept) {
    return figures.contains(key) && (figures[key].*is)();
  };
  const auto isCount = [&](const char *key) { return has(key, &Json::is_number_unsigned); };
  const auto isNumber = [&](const char *key) { return has(key, &Json::is_number); };
  const auto isLevel = [](const Json &level) {
    return level.is_object() && level.contains("words") && level["words"].is_number_unsigned();
  };
  return figures.is_object() &&
         std::ranges::all_of(std::array{"words", "bytes", "file_bytes", "voxels"}, isCount) &&
         std::ranges::all_of(
             std::array{"compile_seconds", "build_seconds", "build_cpu_seconds", "write_seconds"},
             isNumber) &&
         has("levels", &Json::is_array) && std::ranges::all_of(figures["levels"], isLevel) &&
         has("extent", &Json::is_array) && figures["extent"].size() == 3 &&
         std::ranges::all_of(figures["extent"], [](const Json &axis) { return axis.is_number_unsigned(); });
}

} // namespace

void addVolume(const Json &figures, bench::Record &record) {
  const auto count = [&](const char *key) { return figures.value(key, std::uint64_t{0}); };
  const auto seconds = [&](const char *key) { return figures.value(key, 0.0); };
  const std::uint64_t voxels = count("voxels");
  std::vector<std::uint64_t> levelWords;
  for (const Json &level : figures.value("levels", Json::array()))
    levelWords.push_back(level.value("words", std::uint64_t{0}));
  record.volume = {count("words"), count("bytes"), count("file_bytes"),
                   static_cast<double>(count("bytes")) /
                       static_cast<double>(std::max<std::uint64_t>(voxels, 1)),
                   std::move(levelWords)};
  record.build = {{},
                  seconds("compile_seconds"),
                  seconds("build_seconds"),
                  seconds("build_cpu_seconds"),
                  seconds("write_seconds"),
                  {}};
  record.model.voxels = voxels;
  record.model.size = figures.value("extent", std::array<std::uint64_t, 3>{});
}

std::optional<Volume> loadKept(const std::string &path, const std::string &figuresPath, Json &figures) {
  const auto text = readTextFile(figuresPath);
  figures = text ? Json::parse(*text, nullptr, false) : Json();
  if (!areWhole(figures))
    return std::nullopt;
  auto volume = Volume::load(path, {.trusted = true});
  return volume ? std::optional(std::move(*volume)) : std::nullopt;
}

} // namespace voxc::tool
