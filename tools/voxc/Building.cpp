// Building volumes for the driver.
#include "Building.h"

#include "common/Statistics.h"
#include "frontend/FormatArgument.h"
#include "voxc/Construct/Constructor.h"

#include <filesystem>

namespace voxc::tool {

void Building::declare(CLI::App &app) {
  app.add_option("FORMAT", format_, "Format string, .vir file, or - for standard input")
      ->required()
      ->type_name("");
  app.add_option("INPUT", input_, "A mesh, points, a .hvx volume, grid:WxHxD:FILE or builtin:NAME[:N]")
      ->required()
      ->type_name("");
  addInputArguments(app, inputArguments_);
  passes_.declare(app, PassChoice::All);
}

void Building::defaultInput(CLI::App &app, const std::string &input) {
  input_ = input;
  app.get_option("INPUT")->required(false)->capture_default_str();
}

Expected<Format> Building::readFormat() const {
  Expected<Format> format = tool::readFormat(format_);
  if (!format)
    return format;
  if (Expected<void> passed = passes_.apply(*format); !passed)
    return passed.error();
  return format;
}

namespace {

void addInputFigures(Json &figures, const Input &input) {
  figures["load_seconds"] = input.loadSeconds;
  figures["voxelize_seconds"] = input.voxelizeSeconds;
  figures["triangles"] = input.triangles;
  figures["warnings"] = input.warnings.size();
}

void addBuildFigures(Json &figures, const BuildReport &report) {
  figures["build_seconds"] = report.seconds;
  figures["unique_nodes"] = report.uniqueNodes;
  figures["shared_nodes"] = report.sharedNodes;
}

} // namespace

Expected<Volume> Building::build(const Format &format, const CommonOptions &common, const Progress &progress,
                                 Json &figures) const {
  Expected<Constructor> constructor = Constructor::compile(format);
  if (!constructor)
    return constructor.error();

  InputOptions options = makeInputOptions(inputArguments_, format.extent());
  options.progress = progress;
  Expected<Input> input = openInput(input_, options);
  if (!input)
    return input.error();
  Expected<Built> built =
      constructor->build(*input->source, {.provenance = input->provenance, .progress = progress});
  if (!built)
    return built.error();

  if (!common.quiet)
    for (const std::string &warning : input->warnings)
      printNote("warning: " + warning);
  addVolumeFigures(figures, built->volume);
  figures["passes"] = passes_.names();
  figures["compile_seconds"] = constructor->compileSeconds();
  addInputFigures(figures, *input);
  addBuildFigures(figures, built->report);
  return std::move(built->volume);
}

Expected<void> saveVolume(const Volume &volume, const std::string &path, Json &figures) {
  if (Expected<void> saved = volume.save(path); !saved)
    return saved;
  std::error_code ignored;
  figures["file_bytes"] = std::filesystem::file_size(path, ignored);
  return {};
}

} // namespace voxc::tool
