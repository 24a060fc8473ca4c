// What opening an input and building a volume tell.
#include "options/BuildFigures.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace voxc::tool {
namespace {

Json levelFigures(const std::vector<LevelReport> &levels) {
  Json rows = Json::array();
  for (const LevelReport &level : levels)
    rows.push_back(
        {{"words", level.words}, {"unique_nodes", level.uniqueNodes}, {"shared_nodes", level.sharedNodes}});
  return rows;
}

} // namespace

void tellWarnings(const Input &input, const CommonOptions &common, ToldSentences &told) {
  if (common.quiet)
    return;
  const auto tell = [&](const char *kind, const std::vector<std::string> &sentences) {
    for (const std::string &sentence : sentences)
      if (told.insert(kind + sentence).second)
        printNote(kind + sentence);
  };
  tell("warning: ", input.warnings);
  tell("note: ", input.notes);
}

void addInputFigures(Json &figures, const Input &input) {
  figures["load_seconds"] = input.loadSeconds;
  figures["bin_seconds"] = input.binSeconds;
  figures["triangles"] = input.triangles;
  figures["loader_peak_bytes"] = input.loaderPeakBytes;
  figures["warnings"] = input.warnings.size();
  if (input.interior != Interior::Keep) {
    figures[input.interior == Interior::Drop ? "dropped_voxels" : "filled_voxels"] = input.interiorVoxels;
    figures["interior_seconds"] = input.interiorSeconds;
  }
  if (input.isCropped)
    figures["crop_low"] = {input.cropLow.x, input.cropLow.y, input.cropLow.z};
}

void addBuildFigures(Json &figures, const BuildReport &report) {
  figures["build_seconds"] = report.seconds;
  figures["build_cpu_seconds"] = report.cpuSeconds;
  figures["voxelize_seconds"] = report.readSeconds;
  figures["write_seconds"] = report.writeSeconds;
  figures["scratch_bytes"] = report.scratchBytes;
  std::uint64_t unique = 0;
  std::uint64_t shared = 0;
  for (const LevelReport &level : report.levels) {
    unique += level.uniqueNodes;
    shared += level.sharedNodes;
  }
  figures["unique_nodes"] = unique;
  figures["shared_nodes"] = shared;
  figures["value_words"] = report.valueWords;
  figures["levels"] = levelFigures(report.levels);
}

void addFileFigure(Json &figures, const std::string &path) {
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(path, ignored);
  figures["file_bytes"] = ignored ? 0 : bytes;
}

} // namespace voxc::tool
