// Opening slices: PNG pictures and pages of TIFF files, all of one size, one for each z.
#include "Input/Dense/ColourMap.h"
#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/Slice.h"
#include "Input/Openers/InputText.h"
#include "Input/Openers/Openers.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "voxc/Input/NumberedPaths.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace voxc {

namespace {

constexpr std::string_view kKind = "slice";

using ScratchCells = ScratchArray<std::byte>;

class WordRows final : public DenseRows {
public:
  WordRows(Int3 extent, std::shared_ptr<const ScratchCells> cells)
      : extent_(extent), cells_(std::move(cells)) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    std::memcpy(words, cells_->data() + 4 * cellNumber(extent_, first), 4 * static_cast<std::size_t>(count));
  }

private:
  Int3 extent_;
  std::shared_ptr<const ScratchCells> cells_;
};

struct SliceStack {
  Slice slice;
  Int3 extent;
  std::shared_ptr<const ScratchCells> cells;
  bool areWidened = false;         ///< Its samples, to 8 bits.
  std::uint32_t largestColour = 0; ///< Of colours of 16 bits.
  std::vector<std::string> warnings;
  std::optional<StackSpacing> spacing; ///< Of the first file that says one.
};

/// Where the samples are in the units of the file.
Transform mapOf(const SliceStack &stack) {
  Transform map;
  for (int axis = 0; stack.spacing && axis < 3; ++axis)
    map[axis][axis] = stack.spacing->steps[static_cast<std::size_t>(axis)];
  return map;
}

Expected<void> checkExtent(Int3 extent, const InputOptions &options) {
  VOXC_TRY(checkGridExtent(extent));
  const Int3 holds = options.mostExtent();
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("takes " + extentText(extent) + " voxels, but the format holds " + extentText(holds));
  return {};
}

/// Samples of fewer bits as of 8, from black to white.
void widen(std::span<std::byte> samples, unsigned bits) {
  const unsigned white = (1u << bits) - 1;
  for (std::byte &sample : samples)
    sample = std::byte(std::to_integer<unsigned>(sample) * 255 / white);
}

/// Programs that make pictures small store each with as few bits as it needs.
void widenStack(SliceStack &stack, std::span<std::byte> cells) {
  widen(cells, stack.slice.bits);
  stack.slice.bits = 8;
  stack.warnings.emplace_back("its pictures have samples of several numbers of bits; all are taken as of 8");
}

/// Appends the next picture of a file to a stack.
Expected<void> append(const Slice &slice, SliceReader &reader, const InputOptions &options, SliceStack &stack,
                      ScratchCells &cells) {
  if (stack.extent.z == 0)
    stack.slice = slice;
  else if (!slice.isLike(stack.slice))
    return Error::input("it has another size than the first, or colours or samples where that has others");
  stack.extent = {slice.width, slice.height, stack.extent.z + 1};
  VOXC_TRY(checkExtent(stack.extent, options));
  const std::uint64_t begin = cells.size();
  VOXC_TRY(cells.resize(begin + slice.bytes()));
  VOXC_TRY(reader.decode(cells.span().subspan(begin)));
  if (slice.bits != stack.slice.bits && !std::exchange(stack.areWidened, true))
    widenStack(stack, cells.span().first(begin));
  if (stack.areWidened)
    widen(cells.span().subspan(begin), slice.bits);
  options.memory->relieve(slice.bytes());
  return {};
}

/// Appends all pictures of a file.
Expected<void> appendFile(const std::string &path, const InputOptions &options, SliceStack &stack,
                          ScratchCells &cells) {
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  const auto reader = VOXC_TRY(usable(
      isTiff(file->bytes()) ? openTiffSlices(file->bytes()) : openPngSlice(file->bytes()), path, kKind));
  while (true) {
    VOXC_TRY(options.progress.check());
    Slice slice;
    const auto hasOne = VOXC_TRY(usable(reader->next(slice), path, kKind));
    if (!hasOne)
      break;
    VOXC_TRY(usable(append(slice, *reader, options, stack, cells), path, kKind));
  }
  // Of many files that all say the same, once is enough.
  for (std::string &warning : reader->warnings)
    if (std::ranges::find(stack.warnings, warning) == stack.warnings.end())
      stack.warnings.push_back(std::move(warning));
  stack.largestColour = std::max(stack.largestColour, reader->largestColour);
  if (!stack.spacing)
    stack.spacing = reader->spacing;
  return {};
}

/// Cameras of 10 to 14 bits write their numbers into 16 as they are, and most pictures of 16 bits use all.
void tellDarkness(SliceStack &stack) {
  constexpr int kLeastBits = 15;
  const int bits = std::bit_width(stack.largestColour);
  if (stack.largestColour == 0 || bits >= kLeastBits)
    return;
  stack.warnings.push_back("its colours of 16 bits are at most " + std::to_string(stack.largestColour) +
                           ", and dark, as 65535 is the brightest; if they are of " + std::to_string(bits) +
                           " bits, a program for pictures makes them of 16 or 8");
}

Expected<SliceStack> readStack(const std::vector<std::string> &paths, const InputOptions &options) {
  SliceStack stack;
  ScratchCells cells(options.memory);
  for (const std::string &path : paths) {
    VOXC_TRY(options.progress.check());
    VOXC_TRY(appendFile(path, options, stack, cells));
  }
  if (stack.extent.z == 0)
    return notUsable(Error::input("it has no picture"), paths.front(), kKind);
  tellDarkness(stack);
  stack.cells = std::make_shared<const ScratchCells>(std::move(cells));
  return stack;
}

/// Options that mean something for grey pictures alone. Error: one of them is given.
Expected<void> checkOptions(const InputOptions &options) {
  const bool isMapped = options.colourMap != "grey" && options.colourMap != kLabels;
  const char *const given = options.threshold             ? "--threshold"
                            : options.window              ? "--window"
                            : isMapped                    ? "--colour-map"
                            : options.voxelSize.value > 0 ? "--voxel-size"
                            : options.align               ? "--align"
                                                          : nullptr;
  return given ? Error::usage(std::string(given) + " would do nothing for slices in colours; leave it out")
               : Expected<void>();
}

Expected<Input> openWords(const SliceStack &stack, const InputOptions &options) {
  VOXC_TRY(checkOptions(options));
  Input input;
  if (options.describe)
    input.facts = {{"pixels", "colours", {}}, sizeFact("size", stack.extent)};
  input.provenance = "coverage=cells" + upProvenance(options);
  input.source =
      VOXC_TRY(makeUprightSource(stack.extent, std::make_shared<WordRows>(stack.extent, stack.cells), {},
                                 options.zUp, options.memory, options.progress));
  return input;
}

Expected<Input> openSamples(const SliceStack &stack, const InputOptions &options) {
  DenseVolume volume;
  volume.extent = stack.extent;
  volume.layout = {stack.slice.type, std::endian::native == std::endian::big};
  if (!stack.slice.isGrey) {
    volume.channels = 4;
    volume.channelStep = 1;
    volume.steps = {4, 4 * std::int64_t{volume.extent.x},
                    4 * std::int64_t{volume.extent.x} * volume.extent.y};
  }
  volume.samples = stack.cells->data();
  volume.storage = stack.cells;
  volume.sampleToModel = mapOf(stack);
  volume.unit = stack.spacing ? stack.spacing->metres : 0;
  return makeInput(std::move(volume), options);
}

} // namespace

Expected<Input> openSlices(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  const auto paths = VOXC_TRY(numberedPaths(path, static_cast<std::size_t>(options.mostExtent().z)));
  const auto stack = VOXC_TRY(readStack(paths, options));
  // Words as they lie in memory are fastest; cubes can be made of others, too.
  const bool areSamples = stack.slice.isGrey || stack.spacing;
  auto input = VOXC_TRY(areSamples ? openSamples(stack, options) : openWords(stack, options));
  input.warnings.insert(input.warnings.begin(), stack.warnings.begin(), stack.warnings.end());
  for (std::string &sentence : saysBesides(path))
    input.warnings.push_back(std::move(sentence));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
