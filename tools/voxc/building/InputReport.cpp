// Facts of inputs.
#include "building/InputReport.h"

#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/InputArguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace voxc::tool {

namespace {

constexpr int kMostSide = 1 << kMaxLog2Extent;

/// A name as a key: with underscores.
std::string keyOf(std::string name) {
  std::ranges::replace(name, ' ', '_');
  return name;
}

Json valueOf(const InputFact &fact) {
  if (fact.numbers.empty())
    return fact.text;
  const auto number = [](double value) {
    const bool isWhole = std::abs(value) < 0x1p53 && value == std::floor(value);
    return isWhole ? Json(std::int64_t(value)) : Json(value);
  };
  if (fact.numbers.size() == 1)
    return number(fact.numbers.front());
  Json values = Json::array();
  for (const double value : fact.numbers)
    values.push_back(number(value));
  return values;
}

/// A name, and a text whose lines stand below each other.
void printFact(const std::string &name, std::string_view text) {
  std::string head = name;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    std::printf("%-14s%.*s\n", head.c_str(), int(line.size()), line.data());
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    head.clear();
  }
}

std::string rowText(const std::array<double, 12> &rows, std::size_t row) {
  char text[160];
  std::snprintf(text, sizeof text, "%c = %g x + %g y + %g z + %g", "XYZ"[row], rows[4 * row],
                rows[4 * row + 1], rows[4 * row + 2], rows[4 * row + 3]);
  return text;
}

void print(const Input &input, const std::string &voxels) {
  for (const InputFact &fact : input.facts)
    printFact(fact.name, fact.text);
  printFact("as voxels", voxels);
  const auto rows = rowsOf(input.source->voxelToModel());
  printFact("to model", rowText(rows, 0) + "\n" + rowText(rows, 1) + "\n" + rowText(rows, 2));
  for (const std::string &warning : input.warnings)
    printFact("warning", warning);
  for (const std::string &note : input.notes)
    printFact("note", note);
}

} // namespace

bool isVolumePath(const std::string &path) { return path.ends_with(".hvx") || !isKnownInput(path); }

Expected<void> reportInput(const std::string &input, const CommonOptions &common, Json &figures) {
  InputArguments arguments;
  fillResolution(arguments, input);
  ProgressBar bar(common.quiet);
  InputOptions options = makeInputOptions(arguments, {kMostSide, kMostSide, kMostSide});
  options.describe = true;
  options.memory = makeWorkingMemory(BuildArguments());
  options.progress = bar.progress();
  const auto opened = VOXC_TRY(openInput(input, options));
  bar.clear();
  const Int3 extent = opened.source->extent();
  for (const InputFact &fact : opened.facts)
    figures[keyOf(fact.name)] = valueOf(fact);
  figures["extent"] = {extent.x, extent.y, extent.z};
  figures["voxel_to_model"] = rowsOf(opened.source->voxelToModel());
  figures["warnings"] = opened.warnings;
  figures["notes"] = opened.notes;
  const std::string atResolution =
      arguments.resolution > 0 ? ", at --resolution=" + std::to_string(arguments.resolution) : "";
  if (tellsOnStdout(common))
    print(opened, std::to_string(extent.x) + " x " + std::to_string(extent.y) + " x " +
                      std::to_string(extent.z) + atResolution);
  return {};
}

} // namespace voxc::tool
