// MagicaVoxel files: chunks of four letters, the size of their content, and that of their children.
#include "Source/Export/NumberedFiles.h"
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
constexpr std::size_t kMaxColours = 255;

/// The content of a chunk: little-endian words and strings.
class Bytes {
public:
  Bytes &word(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
      text_.push_back(static_cast<char>(value >> shift & 255));
    return *this;
  }
  Bytes &text(std::string_view value) {
    text_ += value;
    return *this;
  }
  Bytes &string(std::string_view value) { return word(static_cast<std::uint32_t>(value.size())).text(value); }
  Bytes &chunk(std::string_view name, const Bytes &content) {
    return text(name).word(static_cast<std::uint32_t>(content.text_.size())).word(0).text(content.text_);
  }
  const std::string &text() const { return text_; }

private:
  std::string text_;
};

/// The voxels of one model, each a word of x, y, z and colour index from the low byte.
struct Model {
  Int3 low;
  std::vector<std::uint32_t> voxels;
};

/// The numbers of colours: given out as colours come, or, of labels, those themselves.
class Palette {
public:
  explicit Palette(bool areLabels) : areLabels_(areLabels) {
    for (std::uint32_t label = 1; areLabels && label <= kMaxColours; ++label)
      colours_.push_back(labelColour(label));
  }

  /// From 1 to 255, or more if there is none.
  std::uint32_t numberOf(std::uint32_t word) {
    if (areLabels_)
      return word;
    const auto [entry, isNew] = numbers_.try_emplace(word, static_cast<std::uint32_t>(colours_.size() + 1));
    if (isNew)
      colours_.push_back(word);
    return entry->second;
  }

  Bytes chunk() const {
    Bytes palette;
    for (std::size_t i = 0; i < 256; ++i)
      palette.word(i < colours_.size() ? colours_[i] : 0);
    return palette;
  }

private:
  bool areLabels_;
  std::vector<std::uint32_t> colours_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
};

bool hasLabels(const Volume &volume) { return volume.layout().payload == Payload::Material; }

class Scene {
public:
  /// With corners, the models in the first and the last corner are always there, so that the scene keeps its
  /// extent.
  Scene(Int3 extent, bool areLabels, bool hasCorners = true) : extent_(extent), palette_(areLabels) {
    if (!hasCorners)
      return;
    modelAt({});
    modelAt(Int3{extent.x - 1, extent.z - 1, extent.y - 1} >> 8);
  }

  /// False if there is no number for the word.
  bool add(Int3 voxel, std::uint32_t word) {
    const std::uint32_t number = palette_.numberOf(word);
    if (number > kMaxColours) {
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

  std::string file() const {
    Bytes children;
    addModels(children);
    addGraph(children);
    children.chunk("RGBA", palette_.chunk());
    Bytes whole;
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

  void addModels(Bytes &children) const {
    for (const auto &[code, model] : models_) {
      const Int3 size = sizeOf(model);
      Bytes content;
      content.word(static_cast<std::uint32_t>(model.voxels.size()));
      for (const std::uint32_t voxel : model.voxels)
        content.word(voxel);
      children.chunk("SIZE", Bytes()
                                 .word(static_cast<std::uint32_t>(size.x))
                                 .word(static_cast<std::uint32_t>(size.y))
                                 .word(static_cast<std::uint32_t>(size.z)));
      children.chunk("XYZI", content);
    }
  }

  /// A transform of node `id`: its child, and where the child's middle lies.
  static Bytes transform(std::uint32_t id, std::uint32_t child, Int3 middle) {
    const std::string place =
        std::to_string(middle.x) + " " + std::to_string(middle.y) + " " + std::to_string(middle.z);
    constexpr std::uint32_t kNone = 0xffffffff; // No reserved id, no layer.
    return Bytes().word(id).word(0).word(child).word(kNone).word(kNone).word(1).word(1).string("_t").string(
        place);
  }

  /// Nodes: 0 is the root, 1 a group, then a transform and a shape for each model.
  void addGraph(Bytes &children) const {
    const auto count = static_cast<std::uint32_t>(models_.size());
    Bytes group;
    group.word(1).word(0).word(count);
    for (std::uint32_t i = 0; i < count; ++i)
      group.word(2 + 2 * i);
    children.chunk("nTRN", transform(0, 1, {})).chunk("nGRP", group);
    std::uint32_t i = 0;
    for (const auto &[code, model] : models_) {
      const Int3 half = sizeOf(model) >> 1;
      children.chunk("nTRN", transform(2 + 2 * i, 3 + 2 * i, model.low + half));
      children.chunk("nSHP", Bytes().word(3 + 2 * i).word(0).word(1).word(i).word(0));
      ++i;
    }
  }

  Int3 extent_;
  std::map<std::uint64_t, Model> models_; ///< By the Morton code of their block.
  Palette palette_;
  std::optional<std::uint32_t> refused_;
};

/// Null if the volume has no more colours than a palette holds.
Expected<Rounding> reduceToPalette(const Volume &volume, const Progress &progress) {
  const auto source = makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume));
  return reduceColours(*source, kMaxColours, progress);
}

// Sizes of chunks are 32-bit; a voxel takes a word.
constexpr std::uint64_t kMaxVoxels = std::uint64_t{1} << 29;

Error tooManyColours(std::uint32_t word, bool areLabels) {
  if (areLabels)
    return Error::input(
        "a .vox file holds labels up to 255, as the numbers of its colours, but the volume has "
        "the label " +
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
    auto rounding = reduceToPalette(volume, options.save.progress);
    if (!rounding)
      return rounding.error();
    colours.rounding_ = std::move(*rounding);
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

/// Writes a part after the other.
class SceneFiles {
public:
  SceneFiles(Int3 extent, bool areLabels, const NumberedPath &path)
      : extent_(extent), areLabels_(areLabels), files_(path), scene_(extent, areLabels) {}

  /// False if it goes no further: see `finish`.
  bool add(Int3 voxel, std::uint32_t word) {
    const std::uint64_t cube = mortonCode(voxel >> kLog2Part);
    if (voxels_ != 0 && cube != cube_ && !finishPart())
      return false;
    cube_ = cube;
    ++voxels_;
    if (!scene_.add(voxel, word))
      result_ = tooManyColours(word, areLabels_);
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

private:
  static constexpr int kLog2Part = 10;

  /// Writes what has been added. False: see `result_`.
  bool finishPart() {
    result_ = files_.add(scene_.file());
    scene_ = Scene(extent_, areLabels_, false);
    voxels_ = 0;
    return bool(result_);
  }

  Int3 extent_;
  bool areLabels_;
  NumberedFiles files_;
  Scene scene_;
  std::uint64_t cube_ = 0;
  std::uint64_t voxels_ = 0; ///< Of the part.
  Expected<void> result_;
};

} // namespace

Expected<void> writeMagicaVoxel(const Volume &volume, OutputFile &file, const ExportOptions &options,
                                Exported &exported) {
  if (volume.info().voxels > kMaxVoxels)
    return Error::input("a .vox file cannot hold " + std::to_string(volume.info().voxels) +
                        " voxels; at most 536870912 fit");
  auto colours = Colours::of(volume, options);
  if (!colours)
    return colours.error();
  Scene scene(volume.info().extent, hasLabels(volume));
  const auto add = [&](Int3 voxel, std::uint32_t word) { return scene.add(voxel, (*colours)(word)); };
  if (auto visited = forEachVoxel(volume, options.save.progress, add); !visited)
    return visited;
  if (scene.refused())
    return tooManyColours(*scene.refused(), hasLabels(volume));
  colours->tell(exported);
  const std::string bytes = scene.file();
  return file.write(bytes.data(), bytes.size());
}

Expected<void> writeMagicaVoxelParts(const Volume &volume, const NumberedPath &path,
                                     const ExportOptions &options, Exported &exported) {
  auto colours = Colours::of(volume, options);
  if (!colours)
    return colours.error();
  SceneFiles files(volume.info().extent, hasLabels(volume), path);
  const auto add = [&](Int3 voxel, std::uint32_t word) { return files.add(voxel, (*colours)(word)); };
  if (auto visited = forEachVoxel(volume, options.save.progress, add); !visited)
    return visited;
  if (auto finished = files.finish(); !finished)
    return finished;
  colours->tell(exported);
  exported.files = files.files();
  return {};
}

} // namespace voxc
