// Options of inputs: from the command line, and to the library.
#include "options/InputArguments.h"

#include "voxc/Components/Components.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace voxc::tool {

void addInputArguments(const CommandLine &command, InputArguments &arguments) {
  const OptionGroup group(command, "Input");
  command
      .add("--resolution", arguments.resolution, "Voxels on the longest axis; default: what the format holds")
      .takes("N")
      .between(1, 1 << kMaxLog2Extent);
  command
      .add("--voxel-size", arguments.voxelSize,
           "The side of a voxel in place of a resolution, as 0.5 in units of the model or 0.5mm; a scan is "
           "made anew in such cubes")
      .takes("SIZE")
      .check(problemOfVoxelSize);
  command
      .add("--unit", arguments.unit,
           "What a step of 1 in the model is, for --voxel-size: nm, um, mm, cm, m, km, in or ft; default: "
           "what the file says, metres of glTF")
      .takes("UNIT")
      .check(problemOfUnit);
  command
      .add("--align", arguments.align,
           "A point of the model that the planes between voxels go through on each axis")
      .takes("X,Y,Z")
      .list()
      .values(3);
  command.add("--bounds", arguments.bounds, "Crops a mesh to this box of model space")
      .takes("X0,Y0,Z0,X1,Y1,Z1")
      .list()
      .values(6);
  command
      .add("--up", arguments.up,
           "The axis of a mesh or dense volume that points up: y (default) or z, the default of NIfTI files")
      .takes("AXIS")
      .oneOf(inputValues("--up"));
  command
      .add("--coverage", arguments.coverage,
           "Voxels of a mesh: conservative (default), all that a triangle touches; thin, fewer; inner, thin "
           "with one where a face lies between two; or centre, all whose centre is inside")
      .takes("RULE")
      .oneOf(inputValues("--coverage"));
  command
      .add("--colour", arguments.colour,
           "Colour from a mesh's texture: mean (default) of a voxel's texels, where they are finer than "
           "voxels, or nearest")
      .takes("RULE")
      .oneOf(inputValues("--colour"));
  command
      .add("--threshold", arguments.threshold,
           "Samples of a dense volume from here up are voxels; default: all but 0, or, where these are more "
           "than 30 %, those above the threshold that parts them best")
      .takes("T");
  command
      .add("--colour-map", arguments.colourMap,
           "Colours of a dense volume: grey (default), heat, dusk or polar; labels: samples, or the numbers "
           "of .vox colours, as they are")
      .takes("NAME")
      .suggests({"grey", "heat", "dusk", "polar", "labels"});
  command
      .add("--window", arguments.window,
           "Samples that have the first and last colour; default: the threshold, or the least, and the "
           "greatest")
      .takes("LO,HI")
      .list()
      .values(2);
  command
      .add("--volume", arguments.volume,
           "Which of several volumes or components of a scan, from 1 on; default: the first, with a warning")
      .takes("N")
      .between(1, kMostVolumes);
  command
      .add("--grid", arguments.grid,
           "The grid of a .nvdb or .vdb file, or the array of a .npz or .vti; default: the first that can be "
           "a shape")
      .takes("NAME");
  command
      .add("--interior", arguments.interior,
           "The inside of things: keep (default), drop what no ray from outside reaches, or fill")
      .takes("WHAT")
      .oneOf(inputValues("--interior"));
  command
      .add("--fill-colour", arguments.fillColour,
           "Colour of voxels that fill the inside; default: ffffff, white")
      .takes("RRGGBB")
      .check(problemOfFillColour);
  command.addFlag("--crop", arguments.crop, "Moves the smallest box around all voxels to the origin");
}

Option addVolumePath(const CommandLine &command, std::string &path, InputArguments &arguments,
                     const char *text) {
  command.remove(command.option("--volume"));
  const auto take = [&path, &arguments](const std::string &value) {
    int number = 0;
    const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool isNumber = failure == std::errc() && end == value.data() + value.size() && number > 0;
    isNumber ? void(arguments.volume = number) : void(path = value);
  };
  return command.addTaken("--volume", take, std::string(text) + "; a number: which volume of the input")
      .notEmpty();
}

namespace {

/// The value of `key` in blank-separated "key=value" words, or "".
std::string_view valueOf(std::string_view words, std::string_view key) {
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    if (word.size() > key.size() && word.starts_with(key) && word[key.size()] == '=')
      return word.substr(key.size() + 1);
    words.remove_prefix(std::min(words.size(), word.size() + 1));
  }
  return {};
}

/// The numbers of a comma-separated list, up to the first that is none.
template <typename Number> std::vector<Number> parseNumbers(std::string_view text) {
  std::vector<Number> numbers;
  Number number;
  const char *const end = text.data() + text.size();
  for (const char *at = text.data(); at < end;) {
    const auto [next, failure] = std::from_chars(at, end, number);
    if (failure != std::errc())
      break;
    numbers.push_back(number);
    at = next == end ? end : next + 1;
  }
  return numbers;
}

/// A word of a provenance as it was: %20 is a blank.
std::string decoded(std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool isBlank = word.substr(i, 3) == "%20";
    const bool isCode = isBlank || word.substr(i, 3) == "%25";
    text += isBlank ? ' ' : word[i];
    i += isCode ? 2 : 0;
  }
  return text;
}

} // namespace

void fillFromProvenance(InputArguments &arguments, std::string_view provenance) {
  arguments.isAutomatic = arguments.isAutomatic && valueOf(provenance, "coverage").empty();
  const bool isSized = arguments.resolution != 0 || !arguments.voxelSize.empty();
  const std::vector<int> resolution = parseNumbers<int>(valueOf(provenance, "resolution"));
  if (!isSized && resolution.size() == 1)
    arguments.resolution = resolution.front();
  if (!isSized && arguments.align.empty()) {
    arguments.voxelSize = decoded(valueOf(provenance, "voxel-size"));
    arguments.align = parseNumbers<double>(valueOf(provenance, "align"));
  }
  if (arguments.unit.empty())
    arguments.unit = decoded(valueOf(provenance, "unit"));
  const std::vector<double> bounds = parseNumbers<double>(valueOf(provenance, "bounds"));
  if (arguments.bounds.empty() && bounds.size() == 6)
    arguments.bounds = bounds;
  if (arguments.up.empty())
    arguments.up = valueOf(provenance, "up");
  const std::vector<double> threshold = parseNumbers<double>(valueOf(provenance, "threshold"));
  if (!arguments.threshold && threshold.size() == 1)
    arguments.threshold = threshold.front();
  if (arguments.colourMap.empty())
    arguments.colourMap = valueOf(provenance, "colour-map");
  const std::vector<double> window = parseNumbers<double>(valueOf(provenance, "window"));
  if (arguments.window.empty() && window.size() == 2)
    arguments.window = window;
  const std::vector<int> volume = parseNumbers<int>(valueOf(provenance, "volume"));
  if (arguments.volume == 0 && volume.size() == 1)
    arguments.volume = volume.front();
  if (arguments.grid.empty())
    arguments.grid = decoded(valueOf(provenance, "grid"));
  if (arguments.coverage.empty())
    arguments.coverage = valueOf(provenance, "coverage");
  if (arguments.colour.empty())
    arguments.colour = valueOf(provenance, "colour");
  if (arguments.interior.empty())
    arguments.interior = valueOf(provenance, "interior");
  if (arguments.fillColour.empty())
    arguments.fillColour = valueOf(provenance, "fill-colour");
  arguments.crop = arguments.crop || !valueOf(provenance, "crop").empty();
}

InputOptions makeInputOptions(const InputArguments &arguments, Int3 formatExtent) {
  InputOptions options = inputOptionsOf(arguments, formatExtent);
  options.otherKinds = componentInputs();
  return options;
}

} // namespace voxc::tool
