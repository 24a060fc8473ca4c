// voxc compile: writes what voxc generates for a format.
#include "Artefacts.h"
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "frontend/AttributeOptions.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

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

class CompileCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  Expected<std::vector<Artefact>> generate(const Format &format) const;
  Expected<void> write(const std::vector<Artefact> &artefacts) const;

  CommonOptions common_;
  AttributeOptions attributes_;
  PassOptions passes_;
  std::string format_;
  std::string folder_ = ".";
  std::vector<std::string> kinds_{"construct", "glsl"};
  std::string addressing_{toString(Addressing::Buffer)};
  bool optimise_ = false;
  CpuObjectOptions cpu_;
  std::string name_;
};

void CompileCommand::declare(const CommandLine &command) {
  command.add("FORMAT", format_, "Format string, .vir file, or - for standard input").required().takes("");
  command.add("-o,--output", folder_, "Folder to write to, or - to print one kind")
      .takes("DIR")
      .showsDefault();
  command
      .add("--emit", kinds_,
           "What to write, of ir, plan, construct, glsl, spirv, spvasm, interface, hlsl, msl, cpp, "
           "cpu, header, c, "
           "webgl, rint, separated by commas")
      .list()
      .takes("KINDS")
      .oneOf(artefactNames())
      .showsDefault("construct,glsl");
  command
      .add("--addressing", addressing_,
           "How the kernel reaches the words: in one buffer, in segments, or as texels")
      .takes("buffer|segments")
      .oneOf(addressingNames())
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
  command
      .add("--name", name_,
           "Name of what is in a header: its functions begin with voxc_NAME_; default: made of the format")
      .takes("NAME");
  attributes_.declare(command);
  attributes_.declareBounds(command);
  passes_.declare(command, PassChoice::All);
  addCommonOptions(command, common_);
}

Expected<std::vector<Artefact>> CompileCommand::generate(const Format &format) const {
  const auto *addressing =
      std::ranges::find(kAddressings, addressing_, [](Addressing each) { return toString(each); });
  const KernelChoices choices = {*addressing, optimise_, cpu_, name_};
  return makeArtefacts(format, kinds_, choices, folder_ == "-");
}

Expected<void> CompileCommand::write(const std::vector<Artefact> &artefacts) const {
  if (folder_ == "-")
    return writeText("-", artefacts.front().contents);
  if (Expected<void> made = makeOutputFolder(folder_); !made)
    return made;
  for (const Artefact &artefact : artefacts)
    if (Expected<void> written =
            writeText((std::filesystem::path(folder_) / artefact.file).string(), artefact.contents);
        !written)
      return written;
  return {};
}

Expected<void> CompileCommand::run() {
  if (folder_ == "-" && kinds_.size() != 1)
    return Error::usage("-o - prints one kind, but --emit names " + std::to_string(kinds_.size()));
  if (folder_ == "-")
    if (Expected<void> free = checkOutput(folder_, common_); !free)
      return free;
  Expected<Format> format = readFormat(format_);
  if (!format)
    return format.error();
  if (Expected<void> passed = passes_.apply(*format, tellingMissed(common_.quiet)); !passed)
    return passed;
  if (Expected<void> applied = attributes_.apply(*format); !applied)
    return applied;

  const Stopwatch watch;
  Expected<std::vector<Artefact>> artefacts = generate(*format);
  if (!artefacts)
    return artefacts.error();
  Json figures{{"format", toString(*format)}, {"emit_seconds", watch.seconds()}};
  for (const Artefact &artefact : *artefacts)
    figures["files"].push_back(artefact.file);
  if (Expected<void> written = write(*artefacts); !written)
    return written;
  if (folder_ != "-" && !common_.quiet)
    for (const Artefact &artefact : *artefacts)
      printNote("wrote " + (std::filesystem::path(folder_) / artefact.file).string());
  return writeStatistics(common_.stats, figures);
}

} // namespace

std::unique_ptr<Subcommand> makeCompileCommand() { return std::make_unique<CompileCommand>(); }

} // namespace voxc::tool
