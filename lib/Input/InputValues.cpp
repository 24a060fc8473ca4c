// Values of options of inputs: which there are, and what they are to the library.
#include "voxc/Input/Arguments.h"
#include "voxc/Input/Units.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace voxc {

namespace {

/// An option that takes one of a few values.
struct ChoiceRow {
  std::string_view option;
  std::string_view what; ///< What a value is called.
  std::string InputArguments::*value;
  std::vector<std::string> values;
};

const std::vector<ChoiceRow> &choices() {
  static const std::vector<ChoiceRow> rows{
      {"--up", "axis that points up", &InputArguments::up, {"y", "z"}},
      {"--coverage", "coverage", &InputArguments::coverage, {kCoverageNames.begin(), kCoverageNames.end()}},
      {"--colour", "rule for colours of textures", &InputArguments::colour, {"mean", "nearest"}},
      {"--interior", "treatment of the inside", &InputArguments::interior, {"keep", "drop", "fill"}}};
  return rows;
}

Interior interiorOf(std::string_view name) {
  return name == "drop" ? Interior::Drop : name == "fill" ? Interior::Fill : Interior::Keep;
}

Expected<void> checkChoice(const ChoiceRow &row, const std::string &value) {
  if (value.empty() || std::ranges::find(row.values, value) != row.values.end())
    return {};
  std::string names;
  for (const std::string &name : row.values)
    names += (names.empty() ? "" : ", ") + name;
  return Error::usage("'" + value + "' is no " + std::string(row.what) + "; there are " + names);
}

Expected<void> checkNumber(const char *option, int value, int most) {
  if (value >= 0 && value <= most)
    return {};
  return Error::usage(std::string(option) + " takes a number from 1 to " + std::to_string(most) + ", not " +
                      std::to_string(value));
}

/// Error: what `problemOf` says of a value that was given.
Expected<void> checkText(const std::string &value, std::string (*problemOf)(const std::string &text)) {
  std::string problem = value.empty() ? "" : problemOf(value);
  if (problem.empty())
    return {};
  return Error::usage(std::move(problem));
}

} // namespace

std::optional<std::uint32_t> parseColour(std::string_view text) {
  std::uint32_t digits = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), digits, 16);
  if (failure != std::errc() || end != text.data() + text.size() || (text.size() != 6 && text.size() != 8))
    return std::nullopt;
  if (text.size() == 6)
    digits = digits << 8 | 255;
  return digits >> 24 | (digits >> 8 & 0xff00) | (digits << 8 & 0xff0000) | digits << 24;
}

std::vector<std::string> inputValues(std::string_view option) {
  const auto row = std::ranges::find(choices(), option, &ChoiceRow::option);
  return row == choices().end() ? std::vector<std::string>() : row->values;
}

std::string problemOfFillColour(const std::string &text) {
  const std::optional<std::uint32_t> word = parseColour(text);
  if (!word)
    return "'" + text + "' is no colour; write rrggbb or rrggbbaa in hexadecimal digits";
  return *word != 0 ? "" : "the colour 00000000 means empty; write another one";
}

std::string problemOfVoxelSize(const std::string &text) {
  if (parseLength(text))
    return "";
  if (text.find_first_of(",x") != std::string::npos)
    return "'" + text +
           "' is no size of voxels, which are cubes; write one number, such as the least of these, and scans "
           "of other spacings are made anew in cubes of it";
  return "'" + text + "' is no size of a voxel; write a number above 0, with a unit or without: one of " +
         unitNames();
}

std::string problemOfUnit(const std::string &text) {
  return metresOf(text) ? "" : "'" + text + "' is no unit that is known; there are " + unitNames();
}

Expected<void> checkInputValues(const InputArguments &arguments) {
  for (const ChoiceRow &row : choices())
    VOXC_TRY(checkChoice(row, arguments.*row.value));
  VOXC_TRY(checkNumber("--resolution", arguments.resolution, 1 << kMaxLog2Extent));
  VOXC_TRY(checkNumber("--volume", arguments.volume, kMostVolumes));
  VOXC_TRY(checkText(arguments.voxelSize, problemOfVoxelSize));
  VOXC_TRY(checkText(arguments.unit, problemOfUnit));
  return checkText(arguments.fillColour, problemOfFillColour);
}

InputOptions inputOptionsOf(const InputArguments &arguments, Int3 formatExtent) {
  InputOptions options;
  options.resolution = arguments.resolution;
  options.formatExtent = formatExtent;
  // What a volume says of itself was not checked; without a meaning it is left out.
  options.voxelSize = parseLength(arguments.voxelSize).value_or(Length());
  options.unit = metresOf(arguments.unit).value_or(0);
  if (arguments.align.size() == 3)
    std::ranges::copy(arguments.align, options.align.emplace().begin());
  options.isAutomatic = arguments.isAutomatic;
  options.isUpKnown = !arguments.up.empty();
  options.zUp = arguments.up == "z";
  // One that is not known was said by a volume, not by who calls.
  options.coverage = coverageOf(arguments.coverage).value_or(options.coverage);
  options.colour = arguments.colour == "nearest" ? ColourRule::Nearest : ColourRule::Mean;
  if (arguments.bounds.size() == 6)
    std::ranges::copy(arguments.bounds, options.bounds.emplace().begin());
  options.threshold = arguments.threshold;
  if (!arguments.colourMap.empty())
    options.colourMap = arguments.colourMap;
  if (arguments.window.size() == 2)
    std::ranges::copy(arguments.window, options.window.emplace().begin());
  options.volume = arguments.volume;
  options.grid = arguments.grid;
  options.interior = interiorOf(arguments.interior);
  // What a volume says of itself was not checked; its voxels are compared anyhow.
  options.fillWord = parseColour(arguments.fillColour).value_or(options.fillWord);
  options.crop = arguments.crop;
  return options;
}

} // namespace voxc
