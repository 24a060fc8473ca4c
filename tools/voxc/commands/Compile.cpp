// voxc compile: writes what voxc generates for a format.
#include "building/Artefacts.h"
#include "common/FiguresFile.h"
#include "common/Files.h"
#include "common/Statistics.h"
#include "frontend/AttributeOptions.h"
#include "frontend/PassOptions.h"
#include "frontend/PlanArgument.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "program/Subcommand.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <variant>

namespace voxc::tool {

namespace {

/// Those of volumes that are on a device as a whole.
constexpr std::array kAddressings = {Addressing::Buffer, Addressing::Segments, Addressing::Texels};

std::vector<std::string> addressingNames() {
  std::vector<std::string> names;
  names.reserve(std::size(kAddressings));
  for (const Addressing addressing : kAddressings)
    names.emplace_back(toString(addressing));
  return names;
}

template <typename Enum> std::vector<std::string> namesOf() {
  return {kEnumNames<Enum>.begin(), kEnumNames<Enum>.end()};
}

class CompileCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  Expected<std::variant<Format, Plan>> readSource() const;
  Expected<void> applyChoices(Format &format) const;
  Expected<std::vector<Artefact>> generate(const std::variant<Format, Plan> &source) const;
  std::string pathOf(const Artefact &artefact) const {
    return (std::filesystem::path(folder_) / artefact.file).string();
  }
  Expected<void> write(const std::vector<Artefact> &artefacts) const;

  std::optional<CommandLine> command_;
  std::vector<std::string> planOptions_; ///< The options that a plan is made by, by name.
  CommonOptions common_;
  AttributeOptions attributes_;
  PassOptions passes_;
  std::string format_;
  std::string folder_ = ".";
  std::vector<std::string> kinds_{"construct", "glsl"};
  std::string addressing_{toString(Addressing::Buffer)};
  std::string loops_{toString(Loops::Cut)};
  std::string arithmetic_{toString(Arithmetic::Any)};
  std::string language_{toString(HeaderLanguage::Shared)};
  bool optimise_ = false;
  CpuObjectOptions cpu_;
  std::string system_{toString(ObjectSystem::Own)};
  std::string name_;
};

void CompileCommand::declare(const CommandLine &command) {
  command_ = command;
  command.add("FORMAT", format_, "Format string, .vir file, the plan of a kernel, or - for standard input")
      .required()
      .takes("");
  command.add("-o,--output", folder_, "Folder to write to, or - to print one kind")
      .takes("DIR")
      .showsDefault();
  command
      .add("--emit", kinds_,
           "What to write, of ir, plan, cpu-plan, header-plan, construct, edit, glsl, spirv, spvasm, "
           "interface, hlsl, msl, cpp, cpu, header, c, webgl, rint, separated by commas")
      .list()
      .takes("KINDS")
      .oneOf(artefactNames())
      .showsDefault("construct,glsl");
  const Option addressing =
      command
          .add("--addressing", addressing_,
               "How the kernel reaches the words: in one buffer, in segments, or as texels")
          .takes("buffer|segments|texels")
          .oneOf(addressingNames())
          .showsDefault();
  const Option loops =
      command
          .add("--loops", loops_,
               "Whether the device runs every loop to its end, as GPUs do, or may cut it short")
          .takes("whole|cut")
          .oneOf(namesOf<Loops>())
          .showsDefault();
  const Option arithmetic =
      command
          .add("--arithmetic", arithmetic_,
               "What the kernel relies on: that the device rounds float32 to nearest if it is asked to, or "
               "that it counts as IEEE 754 says; any is right everywhere")
          .takes("any|nearest|ieee")
          .oneOf(namesOf<Arithmetic>())
          .showsDefault();
  command.addFlag("--spirv-opt", optimise_, "Optimise the kernel with spirv-opt");
  command.add("--symbol", cpu_.symbol, "Name of the function in intersect.cpp and intersect.o")
      .takes("NAME")
      .showsDefault();
  command
      .add("--processor", cpu_.processor,
           "Processor of intersect.o, such as x86-64-v3, or native: this very one; default: any of this "
           "architecture, as fast as each can")
      .takes("NAME");
  command.add("--system", system_, "System of the programs that intersect.o is for")
      .takes("own|windows")
      .oneOf(namesOf<ObjectSystem>())
      .showsDefault();
  command
      .add("--name", name_,
           "Name of what is in a header: its functions begin with voxc_NAME_; default: made of the format")
      .takes("NAME");
  command
      .add("--language", language_,
           "Language of a header: GLSL, that of WebGL 2, C++20, CUDA, HLSL, or that of WebGPU; shared is "
           "GLSL and C++ in one text")
      .takes("shared|glsl|essl|cpp|cuda|hlsl|wgsl")
      .oneOf(namesOf<HeaderLanguage>())
      .showsDefault();
  planOptions_ = {addressing.name(), loops.name(), arithmetic.name()};
  const std::size_t before = command.options().size();
  attributes_.declare(command);
  attributes_.declareBounds(command);
  passes_.declare(command, PassChoice::All);
  const std::vector<Option> options = command.options();
  for (std::size_t i = before; i < options.size(); ++i)
    planOptions_.push_back(options[i].name());
  addCommonOptions(command, common_);
}

Expected<void> CompileCommand::applyChoices(Format &format) const {
  VOXC_TRY(passes_.apply(format, tellingMissed(common_.quiet)));
  return attributes_.apply(format);
}

/// A plan has made its choices already.
Expected<std::variant<Format, Plan>> CompileCommand::readSource() const {
  auto source = VOXC_TRY(readFormatOrPlan(format_));
  if (Format *const format = std::get_if<Format>(&source)) {
    VOXC_TRY(applyChoices(*format));
    return source;
  }
  for (const Option &option : command_->given())
    if (std::ranges::find(planOptions_, option.name()) != planOptions_.end())
      return Error::usage("a plan has made its choices; leave out " + option.name() +
                          ", and change the field of the plan that says it");
  return source;
}

Expected<std::vector<Artefact>> CompileCommand::generate(const std::variant<Format, Plan> &source) const {
  const auto *addressing =
      std::ranges::find(kAddressings, addressing_, [](Addressing each) { return toString(each); });
  const HeaderLanguage language = *fromString<HeaderLanguage>(language_);
  const PlanOptions device = {*addressing, *fromString<Loops>(loops_), *fromString<Arithmetic>(arithmetic_)};
  CpuObjectOptions cpu = cpu_;
  cpu.system = *fromString<ObjectSystem>(system_);
  const KernelChoices choices = {device, optimise_, cpu, name_, language};
  return makeArtefacts(source, kinds_, choices, folder_ == "-");
}

Expected<void> CompileCommand::write(const std::vector<Artefact> &artefacts) const {
  if (folder_ == "-")
    return writeText("-", artefacts.front().contents);
  for (const Artefact &artefact : artefacts)
    VOXC_TRY(checkFiguresApart(common_.stats, pathOf(artefact)));
  VOXC_TRY(makeOutputFolder(folder_));
  for (const Artefact &artefact : artefacts)
    VOXC_TRY(writeText(pathOf(artefact), artefact.contents));
  return {};
}

Expected<void> CompileCommand::run() {
  if (folder_ == "-" && kinds_.size() != 1)
    return Error::usage("-o - prints one kind, but --emit names " + std::to_string(kinds_.size()));
  if (folder_ == "-")
    VOXC_TRY(checkOutput(folder_, common_));
  const auto source = VOXC_TRY(readSource());

  const Stopwatch watch;
  auto artefacts = VOXC_TRY(generate(source));
  const Format *const format = std::get_if<Format>(&source);
  Json figures{{"format", format ? toString(*format) : std::get<Plan>(source).layout.format},
               {"emit_seconds", watch.seconds()}};
  for (const Artefact &artefact : artefacts)
    figures["files"].push_back(artefact.file);
  VOXC_TRY(write(artefacts));
  if (folder_ != "-" && !common_.quiet)
    for (const Artefact &artefact : artefacts)
      printNote("wrote " + pathOf(artefact));
  return writeStatistics(common_.stats, figures);
}

} // namespace

std::unique_ptr<Subcommand> makeCompileCommand() { return std::make_unique<CompileCommand>(); }

} // namespace voxc::tool
