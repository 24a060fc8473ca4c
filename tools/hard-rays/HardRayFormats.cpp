// Reading and making lists of formats.
#include "hard-rays/HardRayFormats.h"

#include "frontend/FormatArgument.h"
#include "testing/RandomFormat.h"
#include "voxc/Support/File.h"

#include <sstream>

namespace voxc::tool {

namespace {

constexpr const char *kDefaults[] = {"R(2^3) G(4)", "D(2^3, 6) S(3)"};
constexpr int kLeastLog2Side = 3, kMostLog2Side = 7;

/// What stands behind the label of a line "label<TAB>format", or all of it.
std::string withoutLabel(const std::string &line) { return line.substr(line.find('\t') + 1); }

} // namespace

void HardRayFormats::declare(const CommandLine &command) {
  command.add("--format", formats_, "A format, as FORMAT of other commands; may be given several times")
      .takes("FORMAT")
      .repeated();
  command.add("--formats", file_, "A file of formats: one a line, a label and a tab before it if you like")
      .takes("FILE");
  command.add("--random", random_, "So many random formats of 2^3 to 2^7 voxels an axis, with random passes")
      .takes("N")
      .between(0u, 1000000u);
  attributes_.declare(command);
  passes_.declare(command, PassChoice::All);
}

Expected<std::vector<std::string>> HardRayFormats::texts() const {
  std::vector<std::string> texts = formats_;
  if (!file_.empty()) {
    auto list = VOXC_TRY(readTextFile(file_));
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);)
      if (!line.empty() && line[0] != '#')
        texts.push_back(withoutLabel(line));
  }
  if (texts.empty() && random_ == 0)
    texts.assign(std::begin(kDefaults), std::end(kDefaults));
  return texts;
}

Expected<std::vector<Format>> HardRayFormats::read(std::uint64_t seed) const {
  const auto written = VOXC_TRY(texts());
  std::vector<Format> formats;
  for (const std::string &text : written) {
    auto format = VOXC_TRY(readFormat(text));
    VOXC_TRY(passes_.apply(format));
    formats.push_back(std::move(format));
  }
  std::mt19937 random(static_cast<std::uint32_t>(seed ^ seed >> 32));
  for (std::uint32_t i = 0; i < random_; ++i) {
    const int log2Side = test::pick(random, kLeastLog2Side, kMostLog2Side);
    formats.push_back(test::randomFormat(random, log2Side));
  }
  for (Format &format : formats)
    VOXC_TRY(attributes_.apply(format));
  return formats;
}

std::string oneLine(const Format &format) {
  std::istringstream words(printIr(format));
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

} // namespace voxc::tool
