// Volumes that a search has built and keeps.
#include "Measure/KeptVolume.h"

#include "Measure/Json.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace voxc::measure {
namespace {

namespace fs = std::filesystem;

std::string besides(const std::string &path, const char *ending) {
  return fs::path(path).replace_extension(ending).string();
}

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

/// What a record tells of a volume.
void addVolume(const Json &figures, Record &record) {
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

Json figuresOf(const std::string &path, const Built &built, double compileSeconds) {
  const VolumeInfo &info = built.volume.info();
  std::error_code ignored;
  const auto fileBytes = fs::file_size(path, ignored);
  Json levels = Json::array();
  for (const LevelReport &level : built.report.levels)
    levels.push_back({{"words", level.words}});
  return {{"words", built.volume.words().size()},
          {"bytes", built.volume.bytes()},
          {"voxels", info.voxels},
          {"extent", {info.extent.x, info.extent.y, info.extent.z}},
          {"compile_seconds", compileSeconds},
          {"build_seconds", built.report.seconds},
          {"build_cpu_seconds", built.report.cpuSeconds},
          {"write_seconds", built.report.writeSeconds},
          {"levels", std::move(levels)},
          {"file_bytes", ignored ? 0 : fileBytes}};
}

} // namespace

std::optional<Volume> loadKept(const std::string &path, Record &record) {
  const auto text = readTextFile(besides(path, kFiguresEnding));
  const Json figures = text ? Json::parse(*text, nullptr, false) : Json();
  if (!areWhole(figures))
    return std::nullopt;
  auto volume = Volume::load(path, {.trusted = true});
  if (!volume)
    return std::nullopt;
  addVolume(figures, record);
  return std::move(*volume);
}

Expected<void> keepBuild(const std::string &path, const Format &storage, const Built &built,
                         double compileSeconds, Record &record) {
  const Json figures = figuresOf(path, built, compileSeconds);
  VOXC_TRY(writeFile(besides(path, kFormatEnding), printIr(storage)));
  VOXC_TRY(writeFile(besides(path, kFiguresEnding), figures.dump() + "\n"));
  addVolume(figures, record);
  return {};
}

} // namespace voxc::measure
