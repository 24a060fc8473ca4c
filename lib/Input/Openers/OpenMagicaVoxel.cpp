// Opening MagicaVoxel files: models placed by a scene graph, in axes whose up is +z. A scene may lie in
// several files, each with a palette of its own.
#include "Input/Openers/Openers.h"

#include "Input/Dense/ColourMap.h"
#include "Input/MagicaVoxel/PlacedVoxels.h"
#include "Input/MagicaVoxel/VoxTwice.h"
#include "Input/Openers/InputText.h"
#include "Source/BinnedVoxels.h"
#include "Source/GridExtent.h"
#include "Support/Text.h"
#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/NumberedPaths.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

constexpr std::string_view kMagicaVoxelFile = "MagicaVoxel file";

/// A file of some megabytes may place its models so often that nothing could hold their voxels.
constexpr std::uint64_t kMostPlaced = std::uint64_t{1} << 30;

/// Voxels that are none, and why.
struct Dropped {
  std::uint64_t noColour = 0; ///< Colour 0.
  std::uint64_t wordZero = 0; ///< A colour whose word is 0.
  std::uint64_t clear = 0;    ///< Kept, but of alpha 0.

  void warn(std::vector<std::string> &warnings) const {
    const auto say = [&](std::uint64_t count, const char *what) {
      if (count != 0)
        warnings.push_back(countedAre(count, "voxel") + what);
    };
    say(noColour, " dropped, of the colour 0, which means empty");
    say(wordZero, " dropped, of a colour whose word is 0, which means empty");
    say(clear, " kept, though of a colour of alpha 0");
  }
};

/// The colours that voxels have, and what of their materials is dropped.
class UsedColours {
public:
  /// Files come one after the other.
  void add(unsigned colour, const VoxFile &file) {
    if (used_.empty() || used_.back().file != &file)
      used_.push_back({&file, {}});
    used_.back().colours.set(colour);
  }

  std::size_t count() const {
    std::size_t count = 0;
    for (const OfFile &used : used_)
      count += used.colours.count();
    return count;
  }

  void warn(std::vector<std::string> &warnings) const {
    constexpr std::array<std::pair<VoxLook, const char *>, 4> kDropped{{{VoxLook::Glass, "glass"},
                                                                        {VoxLook::Emission, "emission"},
                                                                        {VoxLook::Metal, "metal"},
                                                                        {VoxLook::Cloud, "clouds"}}};
    std::string text;
    for (const auto &[look, name] : kDropped)
      if (const std::size_t count = countOf(look); count > 0)
        text += (text.empty() ? "" : ", ") + std::string(name) + " of " + std::to_string(count) +
                (count == 1 ? " colour" : " colours");
    if (!text.empty())
      warnings.push_back("of materials only the colours are kept; dropped: " + text);
  }

private:
  struct OfFile {
    const VoxFile *file;
    std::bitset<256> colours;
  };

  std::size_t countOf(VoxLook look) const {
    std::size_t count = 0;
    for (const OfFile &used : used_)
      for (std::size_t colour = 0; colour < used.colours.size(); ++colour)
        count += used.colours[colour] && used.file->looks[colour] == look;
    return count;
  }

  std::vector<OfFile> used_;
};

/// What the words of voxels of a colour are; 0 is not a voxel.
using WordOfColour = std::uint32_t (*)(unsigned colour, const VoxFile &file);

std::uint32_t emissionOf(unsigned colour, const VoxFile &file) {
  const bool isGlowing = file.looks[colour] == VoxLook::Emission;
  return (isGlowing ? file.colours[colour] & 0xffffff : 0) | 0xff000000;
}

std::uint32_t strengthOf(unsigned colour, const VoxFile &file) {
  return strengthWord(file.looks[colour] == VoxLook::Emission ? file.light[colour] : 0);
}

std::uint32_t metalOf(unsigned colour, const VoxFile &file) {
  const auto byte = [](float share) { return static_cast<std::uint32_t>(std::lround(share * 255)); };
  const VoxLook look = file.looks[colour];
  const bool isMetal = look == VoxLook::Metal;
  // What neither shines nor mirrors is as rough as can be, whatever else is said of it.
  const bool isSmooth = isMetal || look == VoxLook::Glass;
  return byte(look == VoxLook::Glass ? file.clear[colour] : 0) |
         byte(isSmooth ? file.roughness[colour] : 1) << 8 | byte(isMetal ? file.metallic[colour] : 0) << 16 |
         0xff000000;
}

std::uint32_t colourOf(unsigned colour, const VoxFile &file) { return file.colours[colour]; }

/// In the order of `MaterialWords`.
constexpr std::array<WordOfColour, 4> kWordsOf{colourOf, emissionOf, strengthOf, metalOf};

Expected<void> addPart(SceneParts &parts, std::shared_ptr<const WatchedFile> bytes,
                       std::optional<std::int32_t> frame) {
  auto file = VOXC_TRY(readVoxFile(bytes->bytes(), frame.value_or(0)));
  ScenePart &part = parts.emplace_back(ScenePart{std::move(bytes), std::move(file), {}});
  part.scene = VOXC_TRY(makeVoxScene(part.file, frame));
  return {};
}

/// Makes the box of a part that of all its frames, so that a voxel has one place in all of them.
Expected<void> coverAllFrames(ScenePart &part) {
  Long3 &low = part.scene.low, &size = part.scene.size;
  for (std::int32_t frame = 0; frame < part.scene.frames; ++frame) {
    const auto file = readVoxFile(part.bytes->bytes(), frame);
    const auto scene = VOXC_TRY(file ? makeVoxScene(*file, frame) : file.error());
    if (scene.instances.empty())
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t end = std::max(low[axis] + size[axis], scene.low[axis] + scene.size[axis]);
      low[axis] = std::min(low[axis], scene.low[axis]);
      size[axis] = std::min(end - low[axis], kMostSide);
    }
  }
  return {};
}

std::int32_t framesOf(const SceneParts &parts) {
  std::int32_t frames = 1;
  for (const ScenePart &part : parts)
    frames = std::max(frames, part.scene.frames);
  return frames;
}

std::vector<InputFact> factsOf(const SceneParts &parts, const PlacedVoxels &placed, std::size_t colours) {
  InputFact sizes{"model sizes", "", {}};
  std::uint64_t models = 0, instances = 0;
  constexpr std::uint64_t kMostTold = 8;
  for (const ScenePart &part : parts) {
    for (const VoxModel &model : part.file.models) {
      const auto &[x, y, z] = model.size;
      if (++models <= kMostTold)
        sizes.text += (sizes.text.empty() ? "" : ", ") + byThree({double(x), double(y), double(z)});
      sizes.numbers.insert(sizes.numbers.end(), {double(x), double(y), double(z)});
    }
    instances += part.scene.instances.size();
  }
  if (models > kMostTold)
    sizes.text += " and " + std::to_string(models - kMostTold) + " more";
  return {countFact("models", models),
          std::move(sizes),
          countFact("placed models", instances),
          countFact("voxels placed", placed.count()),
          countFact("colours used", colours),
          countFact("frames", static_cast<std::uint64_t>(framesOf(parts)))};
}

Expected<Input> openScene(const SceneParts &parts, const InputOptions &options) {
  const PlacedVoxels placed(parts);
  const Int3 extent = placed.extent();
  const Int3 holds = options.mostExtent();
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::usage("takes " + extentText(extent) + " voxels, but the format holds " + extentText(holds) +
                        "; enlarge the format");
  if (placed.count() > kMostPlaced)
    return Error::input("its scene places " + std::to_string(placed.count()) + " voxels; there may be " +
                        std::to_string(kMostPlaced));
  auto voxels = VOXC_TRY(BinnedVoxels::create(extent, options.memory));
  const bool isLabels = options.colourMap == kLabels;
  const WordOfColour material = kWordsOf[static_cast<std::size_t>(options.materialWords)];
  const auto wordOf = [&](unsigned colour, const VoxFile &file) -> std::uint32_t {
    if (isLabels)
      return colour;
    return file.colours[colour] != 0 ? material(colour, file) : 0;
  };
  Dropped dropped;
  UsedColours used;
  auto counted = placed.forEach(options.progress, [&](Int3 voxel, unsigned colour, const VoxFile &file) {
    const std::uint32_t word = wordOf(colour, file);
    dropped.noColour += colour == 0;
    dropped.wordZero += colour != 0 && word == 0;
    dropped.clear += !isLabels && word != 0 && word >> 24 == 0;
    if (word == 0)
      return;
    voxels.count(voxel);
    used.add(colour, file);
  });
  if (!counted)
    return counted.error();
  VOXC_TRY(voxels.allocate());
  auto all = placed.forEach(options.progress, [&](Int3 voxel, unsigned colour, const VoxFile &file) {
    if (const std::uint32_t word = wordOf(colour, file); word != 0)
      voxels.place(voxel, word);
  });
  if (!all)
    return all.error();
  Input input;
  input.words = isLabels ? MaterialWords::Colours : options.materialWords;
  for (const ScenePart &part : parts) {
    input.warnings.insert(input.warnings.end(), part.scene.warnings.begin(), part.scene.warnings.end());
    VOXC_TRY(warnOfVoxelsTwice(part.scene, options.memory, input.warnings));
  }
  dropped.warn(input.warnings);
  used.warn(input.warnings);
  if (options.describe)
    input.facts = factsOf(parts, placed, used.count());
  input.source = std::move(voxels).finish(placed.voxelToModel());
  input.frames = static_cast<std::size_t>(framesOf(parts));
  input.provenance = "coverage=models";
  if (isLabels)
    input.provenance += " colour-map=" + options.colourMap;
  return input;
}

} // namespace

Expected<Input> openMagicaVoxel(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  constexpr std::size_t kMostFiles = 4096;
  const auto named = VOXC_TRY(parseFramePath(path));
  const auto paths = VOXC_TRY(numberedPaths(named.path, kMostFiles));
  std::optional<std::int32_t> frame;
  if (named.frame > 0 || options.boxOfAllFrames)
    frame = std::max(named.frame, 1) - 1;
  SceneParts parts;
  for (const std::string &name : paths) {
    auto file = VOXC_TRY(WatchedFile::open(name, options.memory));
    VOXC_TRY(usable(addPart(parts, std::move(file), frame), name, kMagicaVoxelFile));
    if (options.boxOfAllFrames)
      VOXC_TRY(usable(coverAllFrames(parts.back()), name, kMagicaVoxelFile));
  }
  auto opened = openScene(parts, options);
  if (!opened && opened.error().kind == ErrorKind::Usage)
    return Error::input("'" + path + "' " + opened.error().message);
  auto input = VOXC_TRY(usable(std::move(opened), path, kMagicaVoxelFile));
  for (std::string &sentence : saysBesides(named.path))
    input.warnings.push_back(std::move(sentence));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
