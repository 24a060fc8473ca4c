// MagicaVoxel files: models of a scene graph and their palette.
#include "Source/Export/NumberedFiles.h"
#include "Source/Export/VoxEntries.h"
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"
#include "voxc/Source/Sources.h"
#include "voxc/Volume/LabelColour.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace voxc {

namespace {

constexpr int kModelSide = 256;

/// The voxels of one model, each a word of x, y, z and colour index from the low byte.
struct Model {
  Int3 low;
  std::vector<std::uint32_t> voxels;
};

bool hasLabels(const Volume &volume) { return volume.layout().hasLabels(); }

class Scene {
public:
  /// With corners, the models in the first and the last corner are always there, so that the scene keeps its
  /// extent.
  Scene(Int3 extent, const VoxLooksOf &looks, bool hasCorners = true) : extent_(extent), entries_(looks) {
    if (!hasCorners)
      return;
    modelAt({});
    modelAt(Int3{extent.x - 1, extent.z - 1, extent.y - 1} >> 8);
  }

  /// False if there is no number for the word.
  bool add(Int3 voxel, std::uint32_t word, std::uint32_t look) {
    const std::uint32_t number = entries_.numberOf(word, look);
    if (number > kMostVoxEntries) {
      refused_ = word;
      return false;
    }
    const Int3 turned{voxel.x, extent_.z - 1 - voxel.z, voxel.y};
    Model &model = modelAt(turned >> 8);
    const Int3 cell = turned - model.low;
    model.voxels.push_back(static_cast<std::uint32_t>(cell.x | cell.y << 8 | cell.z << 16) | number << 24);
    return true;
  }

  /// The word for which there was no number.
  std::optional<std::uint32_t> refused() const { return refused_; }
  /// Whether all looks are held as they are.
  bool areLooksWhole() const { return entries_.areWhole(); }

  std::string file() const {
    VoxBytes children;
    addModels(children);
    addGraph(children);
    entries_.addChunks(children);
    VoxBytes whole;
    whole.text("VOX ").word(150).text("MAIN").word(0);
    whole.word(static_cast<std::uint32_t>(children.text().size())).text(children.text());
    return whole.text();
  }

private:
  Model &modelAt(Int3 block) {
    Model &model = models_[mortonCode(block)];
    model.low = block * kModelSide;
    return model;
  }

  Int3 sizeOf(const Model &model) const {
    const Int3 rest = Int3{extent_.x, extent_.z, extent_.y} - model.low;
    return {std::min(rest.x, kModelSide), std::min(rest.y, kModelSide), std::min(rest.z, kModelSide)};
  }

  void addModels(VoxBytes &children) const {
    for (const auto &[code, model] : models_) {
      const Int3 size = sizeOf(model);
      VoxBytes content;
      content.word(static_cast<std::uint32_t>(model.voxels.size()));
      for (const std::uint32_t voxel : model.voxels)
        content.word(voxel);
      children.chunk("SIZE", VoxBytes()
                                 .word(static_cast<std::uint32_t>(size.x))
                                 .word(static_cast<std::uint32_t>(size.y))
                                 .word(static_cast<std::uint32_t>(size.z)));
      children.chunk("XYZI", content);
    }
  }

  /// A transform of node `id`: its child, and where the child's middle lies.
  static VoxBytes transform(std::uint32_t id, std::uint32_t child, Int3 middle) {
    const std::string place =
        std::to_string(middle.x) + " " + std::to_string(middle.y) + " " + std::to_string(middle.z);
    constexpr std::uint32_t kNone = 0xffffffff; // No reserved id, no layer.
    return VoxBytes()
        .word(id)
        .word(0)
        .word(child)
        .word(kNone)
        .word(kNone)
        .word(1)
        .word(1)
        .string("_t")
        .string(place);
  }

  /// Nodes: 0 is the root, 1 a group, then a transform and a shape for each model.
  void addGraph(VoxBytes &children) const {
    const auto count = static_cast<std::uint32_t>(models_.size());
    VoxBytes group;
    group.word(1).word(0).word(count);
    for (std::uint32_t i = 0; i < count; ++i)
      group.word(2 + 2 * i);
    children.chunk("nTRN", transform(0, 1, {})).chunk("nGRP", group);
    std::uint32_t i = 0;
    for (const auto &[code, model] : models_) {
      const Int3 half = sizeOf(model) >> 1;
      children.chunk("nTRN", transform(2 + 2 * i, 3 + 2 * i, model.low + half));
      children.chunk("nSHP", VoxBytes().word(3 + 2 * i).word(0).word(1).word(i).word(0));
      ++i;
    }
  }

  Int3 extent_;
  std::map<std::uint64_t, Model> models_; ///< By the Morton code of their block.
  VoxEntries entries_;
  std::optional<std::uint32_t> refused_;
};

/// Null if the volume has no more colours than a palette holds.
Expected<Rounding> reduceToPalette(const Volume &volume, const Progress &progress) {
  const auto source = makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume));
  return reduceColours(*source, kMostVoxEntries, progress);
}

// Sizes of chunks are 32-bit; a voxel takes a word.
constexpr std::uint64_t kMaxVoxels = std::uint64_t{1} << 29;

Error tooManyColours(std::uint32_t word, bool areLabels) {
  if (areLabels)
    return Error::input(
        "a .vox file holds labels up to 255, as the numbers of its colours, but the volume has the label " +
        std::to_string(word));
  return Error::input("a .vox file holds at most 255 colours, but the volume has more; --lossy takes those "
                      "that stand best for them");
}

/// The colours that are written: those of the volume, or of a palette that stands for them.
class Colours {
public:
  /// Errors: as `reduceColours`.
  static Expected<Colours> of(const Volume &volume, const ExportOptions &options) {
    Colours colours;
    if (!options.lossy || hasLabels(volume))
      return colours;
    colours.rounding_ = VOXC_TRY(reduceToPalette(volume, options.save.progress));
    return colours;
  }

  std::uint32_t operator()(std::uint32_t word) {
    if (!rounding_)
      return word;
    const std::uint32_t rounded = rounding_(word);
    loss_.add(word, rounded);
    return rounded;
  }

  void tell(Exported &exported) const {
    if (rounding_)
      exported.loss = loss_.error();
  }

private:
  Rounding rounding_;
  ColourErrorSum loss_;
};

/// What of the looks a file does not hold.
constexpr const char *kLooksInPart = "a material of a .vox file is light of the voxel's own colour, metal or "
                                     "glass; what else the attributes say of light and metal is left out";
constexpr const char *kTooManyLooks = "its voxels have more than 255 pairs of colour and material, which a "
                                      ".vox file cannot hold; light and metal are left out";

/// Writes a part after the other.
class SceneFiles {
public:
  SceneFiles(Int3 extent, const VoxLooksOf &looks, const NumberedPath &path)
      : extent_(extent), looks_(looks), files_(path), scene_(extent, looks) {}

  /// False if it goes no further: see `finish`.
  bool add(Int3 voxel, std::uint32_t word, std::uint32_t look) {
    const std::uint64_t cube = mortonCode(voxel >> kLog2Part);
    if (voxels_ != 0 && cube != cube_ && !finishPart())
      return false;
    cube_ = cube;
    ++voxels_;
    hasNoNumber_ = !scene_.add(voxel, word, look);
    if (hasNoNumber_)
      result_ = tooManyColours(word, looks_.areLabels);
    else if (voxels_ > kMaxVoxels)
      result_ = Error::input("a .vox file cannot hold more than 536870912 voxels");
    return bool(result_);
  }

  /// Writes what is left, and completes the set. Error: also what `add` came to.
  Expected<void> finish() {
    if (result_ && (voxels_ != 0 || files_.count() == 0))
      finishPart();
    return result_ ? files_.finish() : result_;
  }

  std::uint64_t files() const { return files_.count(); }
  std::string leftover() const { return files_.leftover(); }
  bool hasNoNumber() const { return hasNoNumber_; }
  bool areLooksWhole() const { return areLooksWhole_; }

private:
  static constexpr int kLog2Part = 10;

  /// Writes what has been added. False: see `result_`.
  bool finishPart() {
    result_ = files_.add(scene_.file());
    areLooksWhole_ = areLooksWhole_ && scene_.areLooksWhole();
    scene_ = Scene(extent_, looks_, false);
    voxels_ = 0;
    return bool(result_);
  }

  Int3 extent_;
  VoxLooksOf looks_;
  NumberedFiles files_;
  Scene scene_;
  std::uint64_t cube_ = 0;
  std::uint64_t voxels_ = 0; ///< Of the part.
  bool hasNoNumber_ = false; ///< A voxel had a pair of colour and look too many.
  bool areLooksWhole_ = true;
  Expected<void> result_;
};

Expected<void> writeOne(const Volume &volume, OutputFile &file, const ExportOptions &options,
                        const VoxelLooks &looks, Exported &exported) {
  auto colours = VOXC_TRY(Colours::of(volume, options));
  Scene scene(volume.info().extent, {hasLabels(volume), looks.all()});
  const auto add = [&](Int3 voxel, std::uint32_t word) {
    return scene.add(voxel, colours(word), looks.at(mortonCode(voxel)));
  };
  VOXC_TRY(forEachVoxel(volume, options.save.progress, add));
  if (scene.refused() && looks.areAny()) {
    exported.warnings.emplace_back(kTooManyLooks);
    return writeOne(volume, file, options, VoxelLooks(), exported);
  }
  if (scene.refused())
    return tooManyColours(*scene.refused(), hasLabels(volume));
  if (!scene.areLooksWhole())
    exported.warnings.emplace_back(kLooksInPart);
  colours.tell(exported);
  const std::string bytes = scene.file();
  return file.write(bytes.data(), bytes.size());
}

Expected<void> writeParts(const Volume &volume, const NumberedPath &path, const ExportOptions &options,
                          const VoxelLooks &looks, Exported &exported) {
  auto colours = VOXC_TRY(Colours::of(volume, options));
  bool hasNoNumber = false;
  {
    SceneFiles files(volume.info().extent, {hasLabels(volume), looks.all()}, path);
    const auto add = [&](Int3 voxel, std::uint32_t word) {
      return files.add(voxel, colours(word), looks.at(mortonCode(voxel)));
    };
    VOXC_TRY(forEachVoxel(volume, options.save.progress, add));
    hasNoNumber = files.hasNoNumber() && looks.areAny();
    if (!hasNoNumber) {
      VOXC_TRY(files.finish());
      if (!files.areLooksWhole())
        exported.warnings.emplace_back(kLooksInPart);
      if (std::string left = files.leftover(); !left.empty())
        exported.warnings.push_back(std::move(left));
      colours.tell(exported);
      exported.files = files.files();
      return {};
    }
  }
  exported.warnings.emplace_back(kTooManyLooks);
  return writeParts(volume, path, options, VoxelLooks(), exported);
}

} // namespace

Expected<void> writeMagicaVoxel(const Volume &volume, OutputFile &file, const ExportOptions &options,
                                Exported &exported) {
  if (volume.info().voxels > kMaxVoxels)
    return Error::input("a .vox file cannot hold " + std::to_string(volume.info().voxels) +
                        " voxels; at most 536870912 fit");
  const auto looks = VoxelLooks::of(volume, options.save.progress);
  return looks ? writeOne(volume, file, options, *looks, exported) : Expected<void>(looks.error());
}

Expected<void> writeMagicaVoxelParts(const Volume &volume, const NumberedPath &path,
                                     const ExportOptions &options, Exported &exported) {
  const auto looks = VoxelLooks::of(volume, options.save.progress);
  return looks ? writeParts(volume, path, options, *looks, exported) : Expected<void>(looks.error());
}

} // namespace voxc
