// Opening an input: a table of prefixes and endings, and one opener for each kind.
#include "voxc/Source/Input.h"

#include "Mesh/PathEnding.h"
#include "Mesh/Ply/PlyReader.h"
#include "Source/ClippedSource.h"
#include "Source/PointSource.h"
#include "voxc/Mesh/MeshSource.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace voxc {

namespace {

std::string toText(Int3 extent) {
  return std::to_string(extent.x) + "x" + std::to_string(extent.y) + "x" + std::to_string(extent.z);
}

int longestAxis(Int3 extent) { return std::max({extent.x, extent.y, extent.z}); }

/// A whole positive number, and nothing else.
std::optional<int> parseCount(std::string_view text) {
  int value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || value < 1)
    return std::nullopt;
  return value;
}

/// "WxHxD".
std::optional<Int3> parseExtent(std::string_view text) {
  Int3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? text.find('x') : text.size();
    const auto size = end == std::string_view::npos ? std::nullopt : parseCount(text.substr(0, end));
    if (!size)
      return std::nullopt;
    extent[axis] = *size;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return extent;
}

/// The shortest text that reads back as the same number.
std::string toText(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// The options that decide the voxels of a model whose longest axis got `resolution` of them.
std::string modelProvenance(const char *coverage, int resolution, const InputOptions &options) {
  std::string text = "resolution=" + std::to_string(resolution) + " coverage=" + coverage;
  if (options.bounds) {
    text += " bounds=";
    for (std::size_t i = 0; i < options.bounds->size(); ++i)
      text += (i == 0 ? "" : ",") + toText((*options.bounds)[i]);
  }
  return text + (options.zUp ? " up=z" : " up=y");
}

constexpr std::array<const char *, 2> kCoverageNames{"conservative", "thin"};

Expected<std::unique_ptr<VoxelSource>> voxelize(std::shared_ptr<const TriangleScene> scene,
                                                const InputOptions &options) {
  const VoxelizeOptions voxelizing{options.resolution, options.formatExtent, options.bounds,
                                   options.zUp,        options.coverage,     options.progress};
  return options.reference ? makeReferenceMeshSource(*scene, voxelizing)
                           : makeMeshSource(std::move(scene), voxelizing, options.memory);
}

Expected<Input> openMesh(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto scene = loadScene(path, options.memory, options.progress);
  if (!scene)
    return scene.error();
  Input input;
  input.loadSeconds = loading.seconds();
  input.loaderPeakBytes = scene->loaderPeakBytes;
  input.triangles = triangleCount(*scene);
  input.warnings = std::move(scene->warnings);
  const Stopwatch binning;
  auto source = voxelize(std::make_shared<const TriangleScene>(std::move(*scene)), options);
  if (!source)
    return source.error();
  input.source = std::move(*source);
  input.binSeconds = binning.seconds();
  input.provenance = modelProvenance(kCoverageNames[static_cast<std::size_t>(options.coverage)],
                                     longestAxis(input.source->extent()), options);
  return input;
}

Expected<Input> openPly(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto reader = PlyReader::open(path);
  if (!reader)
    return reader.error();
  if (hasFaces(reader->header()))
    return openMesh(path, options);
  auto points = readPoints(*reader, options);
  if (!points)
    return points.error();
  Input input;
  input.source = std::move(points->source);
  input.loadSeconds = loading.seconds();
  input.provenance = points->areIndices
                         ? std::string("coverage=indices")
                         : modelProvenance("points", longestAxis(input.source->extent()), options);
  input.warnings = std::move(points->warnings);
  return input;
}

Expected<Input> openVolume(const std::string &path, const InputOptions &) {
  const Stopwatch loading;
  auto volume = Volume::load(path);
  if (!volume)
    return volume.error();
  Input input;
  input.provenance = volume->info().provenance;
  input.source = makeVolumeSource(std::make_shared<const Volume>(std::move(*volume)));
  input.loadSeconds = loading.seconds();
  return input;
}

/// `text` is "WxHxD:FILE".
Expected<Input> openGrid(const std::string &text, const InputOptions &) {
  const Stopwatch loading;
  const std::size_t colon = text.find(':');
  const auto extent = parseExtent(std::string_view(text).substr(0, colon));
  if (!extent || colon == std::string::npos)
    return Error::input("'grid:" + text +
                        "' is not a grid; write its size and file as in grid:64x33x32:FILE.raw");
  auto source = loadGridSource(*extent, text.substr(colon + 1));
  if (!source)
    return source.error();
  Input input;
  input.source = std::move(*source);
  input.loadSeconds = loading.seconds();
  input.provenance = "grid=" + toText(*extent);
  return input;
}

/// `text` is "NAME" or "NAME:N".
Expected<Input> openBuiltin(const std::string &text, const InputOptions &options) {
  const std::size_t colon = text.find(':');
  const bool hasSide = colon != std::string::npos;
  const auto written = hasSide ? parseCount(std::string_view(text).substr(colon + 1)) : std::nullopt;
  if (hasSide && !written)
    return Error::input("'" + text.substr(colon + 1) +
                        "' is not a size; write builtin:NAME:N with N voxels an axis");
  const bool isChosen = hasSide || options.resolution > 0;
  const int side =
      written.value_or(options.resolution > 0 ? options.resolution : longestAxis(options.formatExtent));
  const std::string name = text.substr(0, colon);
  auto source = makeBuiltinSource(name, side);
  if (!source)
    return source.error();
  Input input;
  // Nobody asked for the size of a scene that merely fills the format, so what reaches over it is cut off.
  input.source = isChosen ? std::move(*source) : clip(std::move(*source), options.formatExtent);
  input.provenance = "builtin=" + name + ":" + std::to_string(side);
  return input;
}

struct Kind {
  std::string_view mark; ///< A prefix if it ends in a colon, else an ending.
  Expected<Input> (*open)(const std::string &rest, const InputOptions &options);
};

constexpr std::array<Kind, 8> kKinds{{{"builtin:", openBuiltin},
                                      {"grid:", openGrid},
                                      {".obj", openMesh},
                                      {".glb", openMesh},
                                      {".gltf", openMesh},
                                      {".stl", openMesh},
                                      {".ply", openPly},
                                      {".hvx", openVolume}}};

Error unknownKind(const std::string &input) {
  std::string kinds;
  for (const Kind &kind : kKinds)
    kinds += (kinds.empty() ? "" : " ") + std::string(kind.mark);
  return Error::input("'" + input + "' is no kind of input that is known; there are " + kinds);
}

Expected<Input> dispatch(const std::string &input, const InputOptions &options) {
  const std::string ending = pathEnding(input);
  for (const Kind &kind : kKinds) {
    if (kind.mark.ends_with(':') && input.starts_with(kind.mark))
      return kind.open(input.substr(kind.mark.size()), options);
    if (kind.mark == ending)
      return kind.open(input, options);
  }
  return unknownKind(input);
}

} // namespace

Expected<Input> openInput(const std::string &input, const InputOptions &given) {
  InputOptions options = given;
  if (!options.memory)
    options.memory = WorkingMemory::createDefault();
  Expected<Input> opened = dispatch(input, options);
  if (!opened)
    return opened;
  const Int3 extent = opened->source->extent();
  const Int3 holds = options.formatExtent;
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("'" + input + "' takes " + toText(extent) + " voxels, but the format holds " +
                        toText(holds));
  return opened;
}

} // namespace voxc
