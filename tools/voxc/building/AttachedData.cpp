// Reading what is attached to voxels.
#include "building/AttachedData.h"

#include "options/InputArguments.h"
#include "voxc/Input/EmissionStrength.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace voxc::tool {

namespace {

constexpr int kLog2Cube = 3; // The largest cube that a source reads at once.
constexpr std::size_t kCubeVoxels = std::size_t{1} << (3 * kLog2Cube);

/// "NAME=REST", or none.
std::optional<std::pair<std::string, std::string>> named(const std::string &text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    return std::nullopt;
  return std::pair(text.substr(0, at), text.substr(at + 1));
}

/// The words of an input at the voxels of a volume, a block at a time.
class WordReading {
public:
  WordReading(VoxelSource &input, std::vector<std::byte> elements)
      : input_(input), elements_(std::move(elements)) {}

  /// Errors: the input's.
  Expected<void> read(Int3 voxel, std::uint64_t number) {
    const std::uint64_t code = mortonCode(voxel);
    if (code >> (3 * kLog2Cube) != block_)
      VOXC_TRY(readBlock(code >> (3 * kLog2Cube)));
    std::memcpy(&elements_[number * sizeof(std::uint32_t)], &words_[code % kCubeVoxels],
                sizeof(std::uint32_t));
    return {};
  }

  std::vector<std::byte> take() { return std::move(elements_); }

private:
  Expected<void> readBlock(std::uint64_t block) {
    const Cube cube{mortonCell(block << (3 * kLog2Cube)), kLog2Cube};
    words_.fill(0);
    if (!input_.empty(cube))
      VOXC_TRY(input_.read(cube, words_.data()));
    block_ = block;
    return {};
  }

  VoxelSource &input_;
  std::uint64_t block_ = std::numeric_limits<std::uint64_t>::max();
  std::array<std::uint32_t, kCubeVoxels> words_{};
  std::vector<std::byte> elements_;
};

/// How an input is read whose voxels shall be those of a volume: turned as the volume's were.
InputOptions optionsFor(const std::string &input, const VolumeInfo &info) {
  InputArguments arguments;
  fillFromProvenance(arguments, info.provenance);
  InputArguments own;
  own.isAutomatic = false;
  own.up = arguments.up;
  if (!checkInputArguments(own, input))
    own.up.clear();
  own.volume = arguments.volume;
  own.grid = arguments.grid;
  if (!checkInputArguments(own, input)) {
    own.volume = 0;
    own.grid.clear();
  }
  own.colourMap = "labels";
  if (!checkInputArguments(own, input))
    own.colourMap.clear();
  own.voxelSize = arguments.voxelSize;
  own.align = arguments.align;
  if (!checkInputArguments(own, input)) {
    own.voxelSize.clear();
    own.align.clear();
  }
  own.resolution = std::max({info.extent.x, info.extent.y, info.extent.z});
  if (!checkInputArguments(own, input))
    own.resolution = 0;
  InputOptions options = makeInputOptions(own, info.extent);
  options.keepsSamples = true;
  return options;
}

std::string textOf(Int3 extent) {
  return std::to_string(extent.x) + "x" + std::to_string(extent.y) + "x" + std::to_string(extent.z);
}

/// The words of an input at the voxels of a volume.
Expected<std::vector<std::byte>> wordsAt(const std::string &path, const InputOptions &options,
                                         const Volume &volume, std::uint64_t mostBytes) {
  const Int3 extent = volume.info().extent;
  const auto input = VOXC_TRY(openInput(path, options));
  if (input.source->extent() != extent)
    return Error::input("'" + path + "' has " + textOf(input.source->extent()) +
                        " voxels, but the volume has " + textOf(extent));
  auto elements = VOXC_TRY(zeroElements(volume, sizeof(std::uint32_t), mostBytes));
  WordReading reading(*input.source, std::move(elements));
  Expected<void> done;
  const auto visited = visitVoxels(
      volume,
      [&](Int3 voxel, std::uint64_t number) {
        done = options.progress.stopped() ? Error::interrupted() : reading.read(voxel, number);
        return bool(done);
      },
      options.progress);
  if (!visited)
    return visited.error();
  if (!done)
    return done.error();
  return reading.take();
}

/// What materials say, and the element of a word, whose alpha is the colour's and says nothing.
struct MaterialRow {
  std::string_view name;
  MaterialWords words;
  std::uint32_t (*element)(std::uint32_t word);
};

constexpr std::array<MaterialRow, 3> kMaterials{
    {{"emission", MaterialWords::Emission,
      [](std::uint32_t word) { return (word & 0xffffff) == 0 ? 0 : word | 0xff000000; }},
     {"emission-strength", MaterialWords::EmissionStrength,
      [](std::uint32_t word) { return std::bit_cast<std::uint32_t>(strengthOfWord(word)); }},
     {"metallic-roughness", MaterialWords::MetallicRoughness,
      [](std::uint32_t word) { return word == 0 ? 0 : word | 0xff000000; }}}};

std::string knownMaterials() {
  std::string names;
  for (const MaterialRow &row : kMaterials)
    names += (&row == &kMaterials.front()  ? ""
              : &row == &kMaterials.back() ? " or "
                                           : ", ") +
             std::string(row.name);
  return names;
}

void makeElements(std::vector<std::byte> &words, const MaterialRow &row) {
  for (std::size_t at = 0; at < words.size(); at += sizeof(std::uint32_t)) {
    std::uint32_t word = 0;
    std::memcpy(&word, &words[at], sizeof word);
    word = row.element(word);
    std::memcpy(&words[at], &word, sizeof word);
  }
}

} // namespace

Expected<Attribute> wordsOfInput(const std::string &text, const Volume &volume, std::uint64_t mostBytes,
                                 const Progress &progress) {
  const auto parts = named(text);
  if (!parts)
    return Error::usage("--words is written NAME=INPUT, such as density=scan.nii.gz, not '" + text + "'");
  InputOptions options = optionsFor(parts->second, volume.info());
  options.progress = progress;
  auto words = wordsAt(parts->second, options, volume, mostBytes);
  return words ? Attribute{parts->first, sizeof(std::uint32_t), std::move(*words)}
               : Expected<Attribute>(words.error());
}

Expected<Attribute> materialOfInput(const std::string &text, const Volume &volume, std::uint64_t mostBytes,
                                    const Progress &progress) {
  const auto parts = named(text);
  const auto row = std::ranges::find(kMaterials, parts ? parts->first : "", &MaterialRow::name);
  if (row == kMaterials.end())
    return Error::usage("--material is written NAME=MODEL, and NAME is " + knownMaterials() + ", not '" +
                        text + "'");
  InputArguments arguments;
  fillFromProvenance(arguments, volume.info().provenance);
  // What fills the inside has no material.
  arguments.interior.clear();
  arguments.fillColour.clear();
  arguments.colourMap.clear();
  const Int3 extent = volume.info().extent;
  if (arguments.resolution == 0)
    arguments.resolution = std::max({extent.x, extent.y, extent.z});
  InputOptions options = makeInputOptions(arguments, extent);
  options.materialWords = row->words;
  options.progress = progress;
  auto words = VOXC_TRY(wordsAt(parts->second, options, volume, mostBytes));
  makeElements(words, *row);
  return Attribute{parts->first, sizeof(std::uint32_t), std::move(words)};
}

Expected<Attribute> dataOfFile(const std::string &text, const Volume &volume) {
  const auto parts = named(text);
  const std::size_t colon = parts ? parts->first.find(':') : std::string::npos;
  std::uint32_t bytes = 0;
  const bool isNumber =
      colon != std::string::npos &&
      std::from_chars(parts->first.data() + colon + 1, parts->first.data() + parts->first.size(), bytes)
              .ptr == parts->first.data() + parts->first.size();
  if (!isNumber || bytes == 0)
    return Error::usage("--data is written NAME:BYTES=FILE, such as weight:4=weights.bin, not '" + text +
                        "'");
  const auto file = VOXC_TRY(MappedFile::open(parts->second));
  const auto all = file.bytes();
  if (all.size() / bytes != volume.info().voxels || all.size() % bytes != 0)
    return Error::input("'" + parts->second + "' has " + std::to_string(all.size()) +
                        " bytes, but the volume's " + std::to_string(volume.info().voxels) + " voxels take " +
                        std::to_string(bytes) + " each");
  return Attribute{parts->first.substr(0, colon), bytes, {all.begin(), all.end()}};
}

} // namespace voxc::tool
