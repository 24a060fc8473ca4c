// voxc compile: writes what voxc generates for a format.
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "frontend/AttributeOptions.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>

namespace voxc::tool {

namespace {

/// What artefacts are made of; the kernel is compiled when it is first asked for.
class Generator {
public:
  Generator(const Format &format, Addressing addressing, bool optimise)
      : plan_(makePlan(format, {.addressing = addressing})), optimise_(optimise) {}

  const Plan &plan() const { return plan_; }

  Expected<const Kernel *> kernel() {
    if (!kernel_) {
      Expected<Kernel> kernel = compileGlsl(emitIntersect(plan_), plan_, optimise_);
      if (!kernel)
        return kernel.error();
      kernel_ = std::move(*kernel);
    }
    return &*kernel_;
  }

private:
  Plan plan_;
  bool optimise_;
  std::optional<Kernel> kernel_;
};

Expected<std::string> makeIr(Generator &generator) { return printIr(generator.plan().format); }
Expected<std::string> makePlanText(Generator &generator) { return printPlan(generator.plan()); }
Expected<std::string> makeConstruct(Generator &generator) { return emitConstruct(generator.plan()); }
Expected<std::string> makeGlsl(Generator &generator) { return emitIntersect(generator.plan()); }

Expected<std::string> makeSpirv(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  if (!kernel)
    return kernel.error();
  const auto bytes = std::as_bytes(std::span((*kernel)->spirv));
  return std::string(reinterpret_cast<const char *>(bytes.data()), bytes.size());
}

Expected<std::string> makeSpirvText(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  return kernel ? disassemble(**kernel) : Expected<std::string>(kernel.error());
}

struct ArtefactKind {
  const char *name; ///< As given to --emit.
  const char *file;
  Expected<std::string> (*make)(Generator &generator);
};

constexpr ArtefactKind kArtefacts[] = {
    {"ir", "format.vir", makeIr},
    {"plan", "format.plan", makePlanText},
    {"construct", "construct.cpp", makeConstruct},
    {"glsl", "intersect.glsl", makeGlsl},
    {"spirv", "intersect.spv", makeSpirv},
    {"spvasm", "intersect.spvasm", makeSpirvText},
};

constexpr const char *kConstructHeaderFile = "voxc_construct.h";

std::vector<std::string> artefactNames() {
  std::vector<std::string> names;
  for (const ArtefactKind &kind : kArtefacts)
    names.emplace_back(kind.name);
  return names;
}

std::vector<std::string> addressingNames() {
  return {std::string(toString(Addressing::Buffer)), std::string(toString(Addressing::Segments))};
}

const ArtefactKind &findArtefact(const std::string &name) {
  return *std::ranges::find_if(kArtefacts, [&](const ArtefactKind &kind) { return name == kind.name; });
}

struct OutputText {
  std::string file;
  std::string text;
};

class CompileCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override;
  Expected<void> run() override;

private:
  Expected<std::vector<OutputText>> generate(const Format &format) const;
  Expected<void> write(const std::vector<OutputText> &outputs) const;

  CommonOptions common_;
  AttributeOptions attributes_;
  PassOptions passes_;
  std::string format_;
  std::string folder_ = ".";
  std::vector<std::string> kinds_{"construct", "glsl"};
  std::string addressing_{toString(Addressing::Buffer)};
  bool optimise_ = false;
};

void CompileCommand::declare(CLI::App &app) {
  app.add_option("FORMAT", format_, "Format string, .vir file, or - for standard input")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", folder_, "Folder to write to, or - to print one kind")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--emit", kinds_,
                 "What to write, of ir, plan, construct, glsl, spirv, spvasm, separated by commas")
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
  attributes_.declare(app);
  passes_.declare(app, PassChoice::All);
  addCommonOptions(app, common_);
}

Expected<std::vector<OutputText>> CompileCommand::generate(const Format &format) const {
  const bool segments = addressing_ == toString(Addressing::Segments);
  Generator generator(format, segments ? Addressing::Segments : Addressing::Buffer, optimise_);
  std::vector<OutputText> outputs;
  for (const std::string &name : kinds_) {
    const ArtefactKind &kind = findArtefact(name);
    Expected<std::string> text = kind.make(generator);
    if (!text)
      return text.error();
    outputs.push_back({kind.file, std::move(*text)});
    if (name == "construct" && folder_ != "-") // So that a plain compiler finds what the text includes.
      outputs.push_back({kConstructHeaderFile, std::string(constructHeader())});
  }
  return outputs;
}

Expected<void> CompileCommand::write(const std::vector<OutputText> &outputs) const {
  if (folder_ == "-")
    return writeText("-", outputs.front().text);
  if (Expected<void> made = makeOutputFolder(folder_); !made)
    return made;
  for (const OutputText &output : outputs)
    if (Expected<void> written =
            writeText((std::filesystem::path(folder_) / output.file).string(), output.text);
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
  attributes_.apply(*format);

  const Stopwatch watch;
  Expected<std::vector<OutputText>> outputs = generate(*format);
  if (!outputs)
    return outputs.error();
  Json figures{{"format", toString(*format)}, {"emit_seconds", watch.seconds()}};
  for (const OutputText &output : *outputs)
    figures["files"].push_back(output.file);
  if (Expected<void> written = write(*outputs); !written)
    return written;
  if (folder_ != "-" && !common_.quiet)
    for (const OutputText &output : *outputs)
      printNote("wrote " + (std::filesystem::path(folder_) / output.file).string());
  return writeStatistics(common_.stats, figures);
}

} // namespace

std::unique_ptr<Subcommand> makeCompileCommand() { return std::make_unique<CompileCommand>(); }

} // namespace voxc::tool
