// Options of inputs as words.
#include "options/InputArguments.h"

#include <cstdio>

namespace voxc::tool {
namespace {

/// A number so that it comes back unchanged.
std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

std::string joined(const std::vector<double> &numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ",") + exact(number);
  return text;
}

} // namespace

std::vector<std::string> toWords(const InputArguments &arguments) {
  std::vector<std::string> words;
  const auto add = [&](const char *option, const std::string &value) {
    if (!value.empty())
      words.push_back(std::string(option) + "=" + value);
  };
  add("--resolution", arguments.resolution == 0 ? "" : std::to_string(arguments.resolution));
  add("--voxel-size", arguments.voxelSize);
  add("--unit", arguments.unit);
  add("--align", joined(arguments.align));
  add("--bounds", joined(arguments.bounds));
  add("--up", arguments.up);
  add("--coverage", arguments.coverage);
  add("--colour", arguments.colour);
  add("--threshold", arguments.threshold ? exact(*arguments.threshold) : "");
  add("--colour-map", arguments.colourMap);
  add("--window", joined(arguments.window));
  add("--volume", arguments.volume == 0 ? "" : std::to_string(arguments.volume));
  add("--grid", arguments.grid);
  add("--interior", arguments.interior);
  add("--fill-colour", arguments.fillColour);
  if (arguments.crop)
    words.push_back("--crop");
  return words;
}

} // namespace voxc::tool
