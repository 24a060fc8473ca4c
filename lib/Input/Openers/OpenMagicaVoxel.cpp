// Opening MagicaVoxel files: models placed by a scene graph, in axes whose up is +z.
#include "Input/Openers/Openers.h"

#include "Input/Dense/ColourMap.h"
#include "Input/MagicaVoxel/VoxScene.h"
#include "Source/BinnedVoxels.h"
#include "Source/GridExtent.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

namespace {

/// A file of some megabytes may place its models so often that nothing could hold their voxels.
constexpr std::uint64_t kMostPlaced = std::uint64_t{1} << 30;

/// The voxels of a scene, with +z turned to +y and the low corner of the box moved to (0, 0, 0).
class PlacedVoxels {
public:
  explicit PlacedVoxels(const VoxScene &scene) : scene_(scene) {}

  Int3 extent() const {
    return {static_cast<int>(scene_.size[0]), static_cast<int>(scene_.size[2]),
            static_cast<int>(scene_.size[1])};
  }

  /// From voxels back to the cells of the scene.
  Transform voxelToModel() const {
    const auto &[x, y, z] = scene_.low;
    const auto farY = static_cast<double>(y + scene_.size[1]);
    return transformOfRows(
        {1, 0, 0, static_cast<double>(x), 0, 0, -1, farY, 0, 1, 0, static_cast<double>(z)});
  }

  std::uint64_t count() const {
    std::uint64_t count = 0;
    for (const VoxInstance &instance : scene_.instances)
      count += instance.model->voxels.size() / 4;
    return count;
  }

  /// Calls `visit(voxel, colour)` for each voxel, the number of its colour being 0 to 255. Errors: a voxel
  /// outside its model; interrupted.
  template <typename Visit> Expected<void> forEach(const Progress &progress, Visit visit) const {
    for (const VoxInstance &instance : scene_.instances) {
      if (progress.stopped())
        return Error::interrupted();
      const VoxModel &model = *instance.model;
      for (std::size_t at = 0; at < model.voxels.size(); at += 4) {
        Long3 cell;
        bool isInside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          cell[axis] = std::to_integer<std::int64_t>(model.voxels[at + axis]);
          isInside = isInside && cell[axis] < model.size[axis];
        }
        if (!isInside)
          return outside(cell, model);
        visit(turned(instance.placement.moveCell(cell)), std::to_integer<unsigned>(model.voxels[at + 3]));
      }
    }
    return {};
  }

private:
  static Error outside(const Long3 &cell, const VoxModel &model) {
    const auto text = [](const Long3 &v, const char *between) {
      return std::to_string(v[0]) + between + std::to_string(v[1]) + between + std::to_string(v[2]);
    };
    return Error::input("the voxel " + text(cell, ", ") + " lies outside its model of " +
                        text(model.size, "x"));
  }

  Int3 turned(const Long3 &cell) const {
    return {static_cast<int>(cell[0] - scene_.low[0]), static_cast<int>(cell[2] - scene_.low[2]),
            static_cast<int>(scene_.size[1] - 1 - (cell[1] - scene_.low[1]))};
  }

  const VoxScene &scene_;
};

/// Voxels that are none, and why.
struct Dropped {
  std::uint64_t noColour = 0; ///< Colour 0.
  std::uint64_t wordZero = 0; ///< A colour whose word is 0.
  std::uint64_t clear = 0;    ///< Kept, but of alpha 0.

  void warn(std::vector<std::string> &warnings) const {
    const auto say = [&](std::uint64_t count, const char *what) {
      if (count != 0)
        warnings.push_back(std::to_string(count) + what);
    };
    say(noColour, " voxels are dropped: they have the colour 0, which means empty");
    say(wordZero, " voxels are dropped: their colour is the word 0, which means empty");
    say(clear, " voxels have a colour of alpha 0; they are kept");
  }
};

Expected<Input> openScene(std::span<const std::byte> bytes, const InputOptions &options) {
  const auto file = readVoxFile(bytes);
  if (!file)
    return file.error();
  auto scene = makeVoxScene(*file);
  if (!scene)
    return scene.error();
  const PlacedVoxels placed(*scene);
  const Int3 extent = placed.extent();
  const Int3 holds = options.mostExtent();
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::usage("takes " + toText(extent) + " voxels, but the format holds " + toText(holds) +
                        "; enlarge the format");
  if (placed.count() > kMostPlaced)
    return Error::input("its scene places " + std::to_string(placed.count()) + " voxels; there may be " +
                        std::to_string(kMostPlaced));
  auto voxels = BinnedVoxels::create(extent, options.memory);
  if (!voxels)
    return voxels.error();
  const bool isLabels = options.colourMap == kLabels;
  const auto wordOf = [&](unsigned colour) { return isLabels ? colour : file->colours[colour]; };
  Dropped dropped;
  auto counted = placed.forEach(options.progress, [&](Int3 voxel, unsigned colour) {
    const std::uint32_t word = wordOf(colour);
    dropped.noColour += colour == 0;
    dropped.wordZero += colour != 0 && word == 0;
    dropped.clear += !isLabels && word != 0 && word >> 24 == 0;
    if (word != 0)
      voxels->count(voxel);
  });
  if (!counted)
    return counted.error();
  if (auto allocated = voxels->allocate(); !allocated)
    return allocated.error();
  auto all = placed.forEach(options.progress, [&](Int3 voxel, unsigned colour) {
    if (const std::uint32_t word = wordOf(colour); word != 0)
      voxels->place(voxel, word);
  });
  if (!all)
    return all.error();
  Input input;
  input.warnings = std::move(scene->warnings);
  dropped.warn(input.warnings);
  input.source = std::move(*voxels).finish(placed.voxelToModel());
  input.provenance = "coverage=models";
  if (isLabels)
    input.provenance += " colour-map=" + options.colourMap;
  return input;
}

} // namespace

Expected<Input> openMagicaVoxel(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto file = WatchedFile::open(path, options.memory);
  if (!file)
    return file.error();
  auto input = openScene((*file)->bytes(), options);
  if (!input && input.error().kind == ErrorKind::Usage)
    return Error::input("'" + path + "' " + input.error().message);
  if (!input && input.error().kind == ErrorKind::Input)
    return Error::input("'" + path + "' is not a usable MagicaVoxel file: " + input.error().message);
  if (input)
    input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
