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

struct Stack {
  Slice slice;
  Int3 extent;
  std::shared_ptr<const ScratchCells> cells;
  std::vector<std::string> warnings;
  std::optional<StackSpacing> spacing; ///< Of the first file that says one.
};

/// Where the samples are in the units of the file.
Transform mapOf(const Stack &stack) {
  Transform map;
  for (int axis = 0; stack.spacing && axis < 3; ++axis)
    map[axis][axis] = stack.spacing->steps[static_cast<std::size_t>(axis)];
  return map;
}

Expected<void> checkExtent(Int3 extent, const InputOptions &options) {
  VOXC_TRY(checkGridExtent(extent));
  const Int3 holds = options.mostExtent();
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("takes " + toText(extent) + " voxels, but the format holds " + toText(holds));
  return {};
}

/// Appends the next picture of a file to a stack.
Expected<void> append(const Slice &slice, SliceReader &reader, const InputOptions &options, Stack &stack,
                      ScratchCells &cells) {
  if (stack.extent.z == 0)
    stack.slice = slice;
  else if (slice != stack.slice)
    return Error::input("it has another size than the first, or colours or samples where that has others");
  stack.extent = {slice.width, slice.height, stack.extent.z + 1};
  VOXC_TRY(checkExtent(stack.extent, options));
  const std::uint64_t begin = cells.size();
  VOXC_TRY(cells.resize(begin + slice.bytes()));
  VOXC_TRY(reader.decode(cells.span().subspan(begin)));
  options.memory->relieve(slice.bytes());
  return {};
}

/// Appends all pictures of a file.
Expected<void> appendFile(const std::string &path, const InputOptions &options, Stack &stack,
                          ScratchCells &cells) {
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  const auto broken = [&](const Error &error) {
    return error.kind == ErrorKind::Input
               ? Error::input("'" + path + "' is not a usable slice: " + error.message)
               : error;
  };
  auto reader = isTiff(file->bytes()) ? openTiffSlices(file->bytes()) : openPngSlice(file->bytes());
  if (!reader)
    return broken(reader.error());
  while (true) {
    if (options.progress.stopped())
      return Error::interrupted();
    Slice slice;
    const auto next = (*reader)->next(slice);
    if (!next)
      return broken(next.error());
    if (!*next)
      break;
    if (auto appended = append(slice, **reader, options, stack, cells); !appended)
      return broken(appended.error());
  }
  // Of many files that all say the same, once is enough.
  for (std::string &warning : (*reader)->warnings)
    if (std::ranges::find(stack.warnings, warning) == stack.warnings.end())
      stack.warnings.push_back(std::move(warning));
  if (!stack.spacing)
    stack.spacing = (*reader)->spacing;
  return {};
}

Expected<Stack> readStack(const std::vector<std::string> &paths, const InputOptions &options) {
  Stack stack;
  ScratchCells cells(options.memory);
  for (const std::string &path : paths) {
    if (options.progress.stopped())
      return Error::interrupted();
    VOXC_TRY(appendFile(path, options, stack, cells));
  }
  if (stack.extent.z == 0)
    return Error::input("'" + paths.front() + "' is not a usable slice: it has no picture");
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

Expected<Input> openWords(const Stack &stack, const InputOptions &options) {
  VOXC_TRY(checkOptions(options));
  Input input;
  if (options.describe)
    input.facts = {{"pixels", "colours", {}}, sizeFact("size", stack.extent)};
  input.provenance = "coverage=cells" + upProvenance(options);
  Int3 extent = stack.extent;
  std::shared_ptr<const DenseRows> rows = std::make_shared<WordRows>(extent, stack.cells);
  Transform voxelToModel;
  if (options.zUp) {
    rows = turnUpright(std::move(rows), extent.y);
    voxelToModel = turnUpright(voxelToModel, extent.y);
    extent = {extent.x, extent.z, extent.y};
  }
  input.source =
      VOXC_TRY(makeDenseSource(extent, std::move(rows), voxelToModel, options.memory, options.progress));
  return input;
}

Expected<Input> openSamples(const Stack &stack, const InputOptions &options) {
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
