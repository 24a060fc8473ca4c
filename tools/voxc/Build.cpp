// voxc build: voxelizes an input and writes its volume.
#include "Building.h"
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Terminal.h"

namespace voxc::tool {

namespace {

class BuildCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    building_.declare(app);
    app.add_option("-o,--output", output_, "Volume to write")->type_name("V.hvx")->required();
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    if (Expected<void> writable = checkOutputFile(output_); !writable)
      return writable;
    Expected<Format> format = building_.readFormat();
    if (!format)
      return format.error();
    Json figures;
    ProgressBar bar(common_.quiet);
    Expected<Volume> volume = building_.build(*format, common_, bar.progress(), figures);
    bar.clear();
    if (!volume)
      return volume.error();
    if (Expected<void> saved = saveVolume(*volume, output_, figures); !saved)
      return saved;
    return tellFigures(common_, figures);
  }

private:
  Building building_;
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeBuildCommand() { return std::make_unique<BuildCommand>(); }

} // namespace voxc::tool
