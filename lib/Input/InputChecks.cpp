// What an option means for an input, by what that is made of.
#include "Support/Text.h"
#include "voxc/Input/Arguments.h"
#include "voxc/Input/Units.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace voxc {

namespace {

/// Inputs by what they are made of.
enum InputMatter : unsigned { kMesh = 1, kDense = 2, kModels = 4, kBuiltin = 8, kOther = 16, kCells = 32 };

struct MatterRow {
  std::string_view mark; ///< A prefix if it ends in a colon, else an ending.
  InputMatter matter;
};

constexpr MatterRow kMatters[] = {
    {"builtin:", kBuiltin}, {"raw:", kDense},       {"grid:", kOther},      {".obj", kMesh},
    {".ply", kMesh},        {".glb", kMesh},        {".gltf", kMesh},       {".stl", kMesh},
    {".nrrd", kDense},      {".nhdr", kDense},      {".nii", kDense},       {".nii.gz", kDense},
    {".hdr", kDense},       {".hdr.gz", kDense},    {".img", kDense},       {".img.gz", kDense},
    {".vdb", kDense},       {".nvdb", kDense},      {".png", kDense},       {".tif", kDense},
    {".npy", kDense},       {".npz", kDense},       {".tiff", kDense},      {".vox", kModels},
    {".hvx", kOther},       {".binvox", kCells},    {".fbx", kMesh},        {".dae", kMesh},
    {".3ds", kMesh},        {".off", kMesh},        {".x3d", kMesh},        {".vti", kDense},
    {".schem", kOther},     {".schematic", kOther}, {".litematic", kOther}, {".las", kMesh},
    {".laz", kOther},       {".e57", kOther},       {".vtk", kOther},
};

/// What an input is made of; nothing if its kind is not known here.
std::optional<InputMatter> matterOf(const std::string &input) {
  std::string lower = lowerCase(input);
  // The number of a frame: scene.vox#3.
  if (const std::size_t mark = lower.rfind('#');
      mark != std::string::npos && lower.find_first_not_of("0123456789", mark + 1) == std::string::npos)
    lower.resize(mark);
  for (const MatterRow &row : kMatters)
    if (row.mark.ends_with(':') ? input.starts_with(row.mark) : lower.ends_with(row.mark))
      return row.matter;
  return std::nullopt;
}

/// An option, and for what it means something.
struct MeaningRow {
  const char *name;
  unsigned matters;
  const char *text;
  bool (*isGiven)(const InputArguments &arguments);
};

/// Inputs of which an ending says more than what they are made of.
bool endsIn(const std::string &input, std::initializer_list<std::string_view> endings) {
  const std::string lower = lowerCase(input);
  return std::ranges::any_of(endings, [&](std::string_view ending) { return lower.ends_with(ending); });
}

constexpr MeaningRow kMeanings[] = {
    {"--resolution", kMesh | kBuiltin, "meshes and built-in scenes; others have voxels of their own",
     [](const InputArguments &arguments) { return arguments.resolution != 0; }},
    {"--voxel-size", kMesh | kDense, "meshes, points and scans",
     [](const InputArguments &arguments) { return !arguments.voxelSize.empty(); }},
    {"--align", kMesh | kDense, "meshes, points and scans",
     [](const InputArguments &arguments) { return !arguments.align.empty(); }},
    {"--unit", kMesh | kDense, "meshes, points and scans",
     [](const InputArguments &arguments) { return !arguments.unit.empty(); }},
    {"--bounds", kMesh, "meshes", [](const InputArguments &arguments) { return !arguments.bounds.empty(); }},
    {"--up", kMesh | kDense | kCells, "meshes and dense volumes",
     [](const InputArguments &arguments) { return !arguments.up.empty(); }},
    {"--coverage", kMesh, "meshes",
     [](const InputArguments &arguments) { return !arguments.coverage.empty(); }},
    {"--colour", kMesh, "meshes", [](const InputArguments &arguments) { return !arguments.colour.empty(); }},
    {"--threshold", kDense, "dense volumes",
     [](const InputArguments &arguments) { return arguments.threshold.has_value(); }},
    {"--colour-map", kDense | kModels, "dense volumes and .vox files",
     [](const InputArguments &arguments) { return !arguments.colourMap.empty(); }},
    {"--window", kDense, "dense volumes",
     [](const InputArguments &arguments) { return !arguments.window.empty(); }},
    {"--volume", kDense, "scans of several volumes",
     [](const InputArguments &arguments) { return arguments.volume != 0; }},
    {"--grid", kDense, "files of several grids",
     [](const InputArguments &arguments) { return !arguments.grid.empty(); }},
};

/// The N of builtin:NAME:N, if it is there.
std::optional<std::string> sizeOfBuiltin(const std::string &input) {
  constexpr std::string_view kPrefix = "builtin:";
  if (!input.starts_with(kPrefix))
    return std::nullopt;
  const std::size_t colon = input.find(':', kPrefix.size());
  return colon == std::string::npos ? std::nullopt : std::optional(input.substr(colon + 1));
}

/// MagicaVoxel models have colours of their own, and numbers of them. Error: another map.
Expected<void> checkModelsMap(const std::string &colourMap) {
  if (colourMap.empty() || colourMap == "labels")
    return {};
  return Error::usage("--colour-map " + colourMap +
                      " is for dense volumes; a .vox file has colours of its own, or takes --colour-map "
                      "labels, the numbers of its colours");
}

/// The options of the grid of voxels. Error: they do not go together, or do nothing.
Expected<void> checkGrid(const InputArguments &arguments, const std::string &input) {
  const bool isSized = !arguments.voxelSize.empty();
  if (isSized && arguments.resolution != 0)
    return Error::usage("--voxel-size and --resolution both say how large voxels are; leave one of them out");
  if ((isSized || !arguments.align.empty()) && endsIn(input, {".nvdb", ".vdb"}))
    return Error::usage(std::string(isSized ? "--voxel-size" : "--align") + " would do nothing for '" +
                        input + "', whose grid has voxels of its own; leave it out");
  const auto length = parseLength(arguments.voxelSize);
  if (!arguments.unit.empty() && !(length && length->metres > 0))
    return Error::usage(
        "--unit says what a --voxel-size such as 5mm means, and would do nothing without; leave it out");
  return {};
}

} // namespace

bool isKnownInput(const std::string &input) { return matterOf(input).has_value(); }

void fillResolution(InputArguments &arguments, const std::string &input) {
  if (!arguments.voxelSize.empty())
    return;
  const unsigned matter = matterOf(input).value_or(kMesh);
  const bool isSized = sizeOfBuiltin(input).has_value();
  if (arguments.resolution == 0 && (matter & (kMesh | kBuiltin)) != 0 && !isSized)
    arguments.resolution = kDefaultResolution;
}

Expected<void> checkInputArguments(const InputArguments &arguments, const std::string &input) {
  if (const std::optional<std::string> size = sizeOfBuiltin(input);
      size && arguments.resolution != 0 && *size != std::to_string(arguments.resolution))
    return Error::usage("--resolution " + std::to_string(arguments.resolution) + " would do nothing for '" +
                        input + "', which says its own; leave it out");
  if (arguments.threshold && std::isnan(*arguments.threshold))
    return Error::usage("--threshold takes a number, not nan");
  const std::optional<InputMatter> matter = matterOf(input);
  if (matter == kModels)
    VOXC_TRY(checkModelsMap(arguments.colourMap));
  if (matter)
    for (const MeaningRow &row : kMeanings)
      if (row.isGiven(arguments) && !(row.matters & *matter))
        return Error::usage(std::string(row.name) + " is for " + row.text + ", and would do nothing for '" +
                            input + "'; leave it out");
  VOXC_TRY(checkGrid(arguments, input));
  if (!arguments.grid.empty() && !endsIn(input, {".nvdb", ".vdb", ".npz", ".vti"}))
    return Error::usage("--grid is for .nvdb, .vdb, .npz and .vti files, and would do nothing for '" + input +
                        "'; leave it out");
  if (!arguments.fillColour.empty() && arguments.interior != "fill" && arguments.coverage != "centre")
    return Error::usage("--fill-colour is for --interior fill; give both, or leave it out");
  const std::vector<double> &bounds = arguments.bounds;
  if (bounds.size() == 6 && bounds[0] == bounds[3] && bounds[1] == bounds[4] && bounds[2] == bounds[5])
    return Error::usage("--bounds is a single point; its second corner should lie above the first");
  return {};
}

} // namespace voxc
