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

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace voxc::tool {

namespace {

std::vector<std::string> addressingNames() {
  return {std::string(toString(Addressing::Buffer)), std::string(toString(Addressing::Segments))};
}

class CompileCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override;
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

void CompileCommand::declare(CLI::App &app) {
  app.add_option("FORMAT", format_, "Format string, .vir file, or - for standard input")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", folder_, "Folder to write to, or - to print one kind")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--emit", kinds_,
                 "What to write, of ir, plan, construct, glsl, spirv, spvasm, interface, hlsl, msl, cpp, "
                 "cpu, header, c, "
                 "webgl, rint, separated by commas")
      ->delimiter(',')
      ->type_name("KINDS")
      ->check(CLI::IsMember(artefactNames()).description(""))
      ->default_str("construct,glsl");
  app.add_option("--addressing", addressing_,
                 "How the kernel reaches the words: in one buffer, or in segments")
      ->type_name("buffer|segments")
      ->check(CLI::IsMember(addressingNames()).description(""))
      ->capture_default_str();
  app.add_flag("--spirv-opt", optimise_, "Optimise the kernel with spirv-opt");
  app.add_option("--symbol", cpu_.symbol, "Name of the function in intersect.cpp and intersect.o")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option(
         "--processor", cpu_.processor,
         "Processor of intersect.o, such as x86-64-v3, or native: this very one; default: any of this "
         "architecture, as fast as each can")
      ->type_name("NAME");
  app.add_option(
         "--name", name_,
         "Name of what is in a header: its functions begin with voxc_NAME_; default: made of the format")
      ->type_name("NAME");
  attributes_.declare(app);
  attributes_.declareBounds(app);
  passes_.declare(app, PassChoice::All);
  addCommonOptions(app, common_);
}

Expected<std::vector<Artefact>> CompileCommand::generate(const Format &format) const {
  const bool segments = addressing_ == toString(Addressing::Segments);
  const KernelChoices choices = {segments ? Addressing::Segments : Addressing::Buffer, optimise_, cpu_,
                                 name_};
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
  if (Expected<void> passed = passes_.apply(*format); !passed)
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
