// voxc build: voxelizes an input and writes its volume.
#include "Building.h"
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Statistics.h"
#include "common/Terminal.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace voxc::tool {

namespace {

/// One of several fragments, as "i/N" with i from 0 to N - 1.
struct FragmentChoice {
  std::uint64_t index = 0;
  std::uint64_t count = 0;
};

std::optional<FragmentChoice> parseFragment(std::string_view text) {
  constexpr std::uint64_t kMostFragments = std::uint64_t{1} << 20;
  FragmentChoice choice;
  const char *const end = text.data() + text.size();
  const auto [slash, badIndex] = std::from_chars(text.data(), end, choice.index);
  if (badIndex != std::errc() || slash == end || *slash != '/')
    return std::nullopt;
  const auto [rest, badCount] = std::from_chars(slash + 1, end, choice.count);
  if (badCount != std::errc() || rest != end || choice.index >= choice.count || choice.count > kMostFragments)
    return std::nullopt;
  return choice;
}

std::string checkFragment(const std::string &text) {
  return parseFragment(text) ? std::string()
                             : "'" + text + "' is no fragment; write i/N with i from 0 to N - 1";
}

class BuildCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    building_.declare(app);
    building_.declareThreads(app);
    building_.declareMaxBytes(app);
    app.add_option("--fragment", fragment_, "Build one of N fragments only, for voxc merge")
        ->type_name("I/N")
        ->check(CLI::Validator(checkFragment, "", ""));
    app.add_option("-o,--output", output_, "Volume to write, or fragment")->type_name("FILE")->required();
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
    if (Expected<void> built = build(*format, bar.progress(), figures); !built) {
      // How far it came; that this cannot be written as well is no news.
      figures["failed"] = built.error().message;
      static_cast<void>(writeStatistics(common_.stats, figures));
      return built;
    }
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  Expected<void> build(const Format &format, const Progress &progress, Json &figures) {
    if (const auto fragment = parseFragment(fragment_))
      return building_.buildFragment(format, fragment->index, fragment->count, output_, common_, progress,
                                     figures);
    Expected<Volume> volume = building_.build(format, output_, common_, progress, figures);
    return volume ? Expected<void>() : volume.error();
  }

  Building building_;
  std::string fragment_;
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeBuildCommand() { return std::make_unique<BuildCommand>(); }

} // namespace voxc::tool
