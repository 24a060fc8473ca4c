// voxc attach: gives the voxels of a volume named attributes, or takes them away.
#include "building/AttachedData.h"
#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Subcommand.h"
#include "voxc/Render/NormalAttribute.h"

namespace voxc::tool {

namespace {

class AttachCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    volume_.declare(command);
    const auto several = [&](const char *name, std::vector<std::string> &values, const char *type,
                             const std::string &summary) {
      command.add(name, values, summary + "; may be given several times").takes(type).repeated();
    };
    {
      const OptionGroup group(command, "Attributes");
      command.addFlag("--normals", normals_,
                      "The direction of the surface at each voxel, as 'normal', packed into 4 bytes");
      several(
          "--words", words_, "NAME=INPUT",
          "What another input has at each voxel, 4 bytes: the samples of a dense volume (int32, or float32 "
          "where they are no whole numbers), the numbers of a palette, or colours; 0 where it has none");
      several("--material", material_, "NAME=MODEL",
              "What the materials of the mesh or .vox file that the volume was made of say at each voxel, 4 "
              "bytes: emission, its light in sRGB, emission-strength, or metallic-roughness; 0 where there "
              "is none");
      several("--data", data_, "NAME:BYTES=FILE",
              "The elements of a file, so many bytes each, one for each voxel by its number");
      several("--drop", drop_, "NAME", "Leave an attribute out that the volume has");
    }
    command.add("-o,--output", output_, "Volume to write; may be the one that is read")
        .takes("V.hvx")
        .required();
    addMemoryArguments(command, arguments_);
    addCompressArgument(command, arguments_.compress);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkOutputFile(output_));
    auto loaded = VOXC_TRY(volume_.load(makeWorkingMemory(arguments_)));
    volume_.noteLostStreams(loaded, common_);
    std::shared_ptr<const Volume> volume = std::make_shared<const Volume>(std::move(loaded));
    if (framesOf(*volume).size() > 1 && !common_.quiet)
      printNote("warning: attributes are of the first frame alone; --frame N with -o gives those of another");
    ProgressBar bar(common_.quiet);
    VOXC_TRY(volume_.leaveOtherFrames(output_, common_));
    const auto changed = VOXC_TRY(change(volume, bar.progress()));
    if (changed == 0)
      return Error::usage(
          "there is nothing to attach; give --normals, --words, --material, --data or --drop");
    if (Expected<void> saved = volume->save(output_, {.compress = arguments_.compress,
                                                      .memory = makeWorkingMemory(arguments_),
                                                      .progress = bar.progress()});
        !saved)
      return saved;
    bar.clear();
    Json figures;
    addVolumeFigures(figures, *volume);
    addWritten(figures, output_);
    return tellFigures(common_, figures);
  }

private:
  /// Applies all options to the volume; returns how many there were.
  Expected<std::size_t> change(std::shared_ptr<const Volume> &volume, const Progress &progress) const {
    const std::uint64_t mostBytes = makeWorkingMemory(arguments_)->bound();
    for (const std::string &name : drop_)
      VOXC_TRY(take(withoutAttribute(volume, name), volume));
    if (normals_)
      if (Expected<void> added =
              add(normalAttribute(*volume, threadsOf(arguments_), progress, mostBytes), volume);
          !added)
        return added.error();
    for (const std::string &text : words_)
      VOXC_TRY(add(wordsOfInput(text, *volume, mostBytes, progress), volume));
    for (const std::string &text : material_)
      VOXC_TRY(add(materialOfInput(text, *volume, mostBytes, progress), volume));
    for (const std::string &text : data_)
      VOXC_TRY(add(dataOfFile(text, *volume), volume));
    return drop_.size() + normals_ + words_.size() + material_.size() + data_.size();
  }

  static Expected<void> take(Expected<Volume> changed, std::shared_ptr<const Volume> &volume) {
    if (!changed)
      return changed.error();
    volume = std::make_shared<const Volume>(std::move(*changed));
    return {};
  }

  static Expected<void> add(Expected<Attribute> attribute, std::shared_ptr<const Volume> &volume) {
    return attribute ? take(withAttribute(volume, std::move(*attribute)), volume) : attribute.error();
  }

  VolumeArgument volume_;
  bool normals_ = false;
  std::vector<std::string> words_, material_, data_, drop_;
  std::string output_;
  BuildArguments arguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeAttachCommand() { return std::make_unique<AttachCommand>(); }

} // namespace voxc::tool
