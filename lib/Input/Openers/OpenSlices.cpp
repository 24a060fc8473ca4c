// Opening slices: PNG pictures of one size, one for each z.
#include "Input/Dense/ColourMap.h"
#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/PngSlice.h"
#include "Input/Openers/InputText.h"
#include "Input/Openers/Openers.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "voxc/Input/NumberedPaths.h"
#include "voxc/Support/Stopwatch.h"

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
  PngSlice slice;
  Int3 extent;
  std::shared_ptr<const ScratchCells> cells;
};

Expected<void> checkExtent(Int3 extent, const InputOptions &options) {
  if (auto possible = checkGridExtent(extent); !possible)
    return possible.error();
  const Int3 holds = options.mostExtent();
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("takes " + toText(extent) + " voxels, but the format holds " + toText(holds));
  return {};
}

Expected<Stack> readStack(const std::vector<std::string> &paths, const InputOptions &options) {
  Stack stack;
  ScratchCells cells(options.memory);
  for (std::size_t z = 0; z < paths.size(); ++z) {
    if (options.progress.stopped())
      return Error::interrupted();
    const auto broken = [&](const std::string &problem) {
      return Error::input("'" + paths[z] + "' is not a usable slice: " + problem);
    };
    auto file = WatchedFile::open(paths[z], options.memory);
    if (!file)
      return file.error();
    const auto slice = readPngSlice((*file)->bytes());
    if (!slice)
      return broken(slice.error().message);
    if (z == 0) {
      stack.slice = *slice;
      stack.extent = {slice->width, slice->height, static_cast<std::int32_t>(paths.size())};
      if (auto fits = checkExtent(stack.extent, options); !fits)
        return broken(fits.error().message);
    } else if (*slice != stack.slice) {
      return broken("it has another size than the first, or colours where that is grey");
    }
    const std::uint64_t begin = cells.size();
    if (auto resized = cells.resize(begin + slice->bytes()); !resized)
      return resized.error();
    if (auto decoded = decodePngSlice((*file)->bytes(), *slice, cells.span().subspan(begin)); !decoded)
      return broken(decoded.error().message);
    options.memory->relieve(slice->bytes());
  }
  stack.cells = std::make_shared<const ScratchCells>(std::move(cells));
  return stack;
}

/// Options that mean something for grey pictures alone. Error: one of them is given.
Expected<void> checkOptions(const InputOptions &options) {
  const bool isMapped = options.colourMap != "grey" && options.colourMap != kLabels;
  const char *const given = options.threshold ? "--threshold"
                            : options.window  ? "--window"
                            : isMapped        ? "--colour-map"
                                              : nullptr;
  return given ? Error::usage(std::string(given) + " would do nothing for slices in colours; leave it out")
               : Expected<void>();
}

Expected<Input> openWords(const Stack &stack, const InputOptions &options) {
  if (auto checked = checkOptions(options); !checked)
    return checked.error();
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
  auto source = makeDenseSource(extent, std::move(rows), voxelToModel, options.memory, options.progress);
  if (!source)
    return source.error();
  input.source = std::move(*source);
  return input;
}

Expected<Input> openSamples(const Stack &stack, const InputOptions &options) {
  DenseVolume volume;
  volume.extent = stack.extent;
  volume.layout = {SampleType::Uint8, false};
  volume.samples = stack.cells->data();
  volume.storage = stack.cells;
  return makeInput(std::move(volume), options);
}

} // namespace

Expected<Input> openSlices(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  const auto paths = numberedPaths(path, static_cast<std::size_t>(options.mostExtent().z));
  if (!paths)
    return paths.error();
  const auto stack = readStack(*paths, options);
  if (!stack)
    return stack.error();
  auto input = stack->slice.isGrey ? openSamples(*stack, options) : openWords(*stack, options);
  if (input)
    input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
