// The choice of an array, its pieces put together, and where they lie.
#include "Input/Vtk/VtkImage.h"

#include "Input/Dense/VolumeChoice.h"
#include "Input/Vtk/VtkData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace voxc {

namespace {

std::string toText(const VtkExtent &extent) {
  std::string text;
  for (const std::int64_t number : extent)
    text += (text.empty() ? "" : " ") + std::to_string(number);
  return text;
}

/// Samples along the axes, and the first of them; an axis of one point has one cell.
struct SampleBox {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> size{};

  bool holds(const SampleBox &other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (other.low[i] < low[i] || other.low[i] + other.size[i] > low[i] + size[i])
        return false;
    return true;
  }
  bool meets(const SampleBox &other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (other.low[i] >= low[i] + size[i] || low[i] >= other.low[i] + other.size[i])
        return false;
    return true;
  }
  std::uint64_t count() const {
    return static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]) *
           static_cast<std::uint64_t>(size[2]);
  }
};

/// Error: an extent that is none, or larger than any volume.
Expected<SampleBox> boxOf(const VtkExtent &extent, bool ofCells) {
  SampleBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t low = extent[2 * i], high = extent[2 * i + 1];
    constexpr std::int64_t kFar = std::int64_t{1} << 40;
    if (low < -kFar || high > kFar || high < low || high - low >= 1 << kMaxLog2Extent)
      return Error::input("its extent " + toText(extent) + " has no points, or more than 2^" +
                          std::to_string(kMaxLog2Extent) + " along an axis");
    box.low[i] = low;
    box.size[i] = ofCells ? std::max<std::int64_t>(high - low, 1) : high - low + 1;
  }
  return box;
}

/// Error: pieces leave a cell out, or have it twice. Neighbours share points.
Expected<void> checkTiles(const VtiFile &file) {
  const auto whole = VOXC_TRY(boxOf(file.whole, true));
  std::vector<SampleBox> boxes;
  std::uint64_t cells = 0;
  for (const VtkPiece &piece : file.pieces) {
    const auto box = VOXC_TRY(boxOf(piece.extent, true));
    const bool isApart =
        std::ranges::none_of(boxes, [&](const SampleBox &other) { return other.meets(box); });
    if (!whole.holds(box) || !isApart)
      return Error::input("its piece of the extent " + toText(piece.extent) +
                          " lies outside of the whole extent " + toText(file.whole) +
                          ", or in another piece; pieces should tile it");
    boxes.push_back(box);
    cells += box.count();
  }
  if (cells != whole.count())
    return Error::input("its pieces have " + std::to_string(cells) + " of the " +
                        std::to_string(whole.count()) + " cells of its extent " + toText(file.whole) +
                        "; they should tile it");
  return {};
}

std::string called(const VtkArray &array) {
  return (array.name.empty() ? "(without a name)" : array.name.substr(0, 80)) +
         (array.isOfCells ? " (of cells)" : "");
}

/// The number of the array in the first piece. A warning names the others.
Expected<std::size_t> chooseArray(const VtiFile &file, const InputOptions &options,
                                  std::vector<std::string> &warnings) {
  const std::vector<VtkArray> &arrays = file.pieces.front().arrays;
  const auto find = [&](const auto &isIt) {
    return static_cast<std::size_t>(std::ranges::find_if(arrays, isIt) - arrays.begin());
  };
  const auto isActive = [&](const VtkArray &array) {
    const std::string &active = array.isOfCells ? file.cellScalars : file.pointScalars;
    return array.type && !active.empty() && array.name == active;
  };
  std::size_t chosen = options.grid.empty()
                           ? find(isActive)
                           : find([&](const VtkArray &array) { return array.name == options.grid; });
  if (options.grid.empty() && chosen == arrays.size())
    chosen = find([](const VtkArray &array) { return array.type && array.name != "vtkGhostType"; });
  std::string others;
  for (std::size_t i = 0; i < arrays.size(); ++i)
    if (i != chosen)
      others += (others.empty() ? "" : ", ") + called(arrays[i]);
  others = others.substr(0, 400);
  if (chosen == arrays.size())
    return Error::input((options.grid.empty() ? std::string("it has no array of numbers")
                                              : "it has no array '" + options.grid + "'") +
                        (others.empty() ? "" : "; there are " + others));
  if (!arrays[chosen].type)
    return Error::input("its array '" + called(arrays[chosen]) + "' is of the type " +
                        arrays[chosen].typeName.substr(0, 40) + "; it should be of numbers, Int8 to Float64");
  if (options.grid.empty() && !others.empty())
    warnings.push_back("the array '" + called(arrays[chosen]) + "' is taken, and left out are " + others +
                       " (--grid NAME takes one of them)");
  return chosen;
}

/// The array of a piece that is that of the first one. Error: there is none.
Expected<const VtkArray *> sameArray(const VtkPiece &piece, const VtkArray &wanted) {
  for (const VtkArray &array : piece.arrays)
    if (array.name == wanted.name && array.isOfCells == wanted.isOfCells) {
      if (array.type == wanted.type && array.components == wanted.components)
        return &array;
      break;
    }
  return Error::input("its piece of the extent " + toText(piece.extent) + " lacks the array '" +
                      called(wanted) + "', or has it of another type");
}

/// Copies the samples of a piece to their place in the whole.
void copyPiece(const SampleBox &whole, const SampleBox &piece, std::size_t bytes, const std::byte *from,
               std::byte *to) {
  const std::size_t row = static_cast<std::size_t>(piece.size[0]) * bytes;
  for (std::int64_t z = 0; z < piece.size[2]; ++z)
    for (std::int64_t y = 0; y < piece.size[1]; ++y) {
      const std::int64_t at =
          ((piece.low[2] - whole.low[2] + z) * whole.size[1] + piece.low[1] - whole.low[1] + y) *
              whole.size[0] +
          piece.low[0] - whole.low[0];
      std::memcpy(to + static_cast<std::size_t>(at) * bytes, from, row);
      from += row;
    }
}

/// The samples of all pieces. Each is read before there is memory for the whole, which a few bytes may claim.
Expected<VtkNumbers> readPieces(const VtiFile &file, const VtkArray &wanted, const SampleBox &whole,
                                std::size_t bytes, const InputOptions &options) {
  std::vector<std::pair<SampleBox, VtkNumbers>> parts;
  for (const VtkPiece &piece : file.pieces) {
    const auto array = VOXC_TRY(sameArray(piece, wanted));
    const auto box = VOXC_TRY(boxOf(piece.extent, wanted.isOfCells));
    auto numbers = VOXC_TRY(readVtkNumbers(file, *array, box.count() * bytes, options));
    if (!parts.empty() && numbers.isBigEndian != parts.front().second.isBigEndian)
      return Error::input("its pieces have an array as text in one and as bytes in another");
    parts.emplace_back(box, std::move(numbers));
  }
  if (parts.size() == 1)
    return std::move(parts.front().second);
  VtkBytes cells(options.memory);
  VOXC_TRY(cells.resize(whole.count() * bytes));
  for (auto &[box, numbers] : parts) {
    if (options.progress.stopped())
      return Error::interrupted();
    copyPiece(whole, box, bytes, numbers.first, cells.data());
    numbers.storage.reset();
    options.memory->relieve(box.count() * bytes);
  }
  const std::byte *const first = cells.data();
  return VtkNumbers{first, std::make_shared<const VtkBytes>(std::move(cells)),
                    parts.front().second.isBigEndian};
}

/// From samples to the model: point (0, 0, 0) lies at the origin, wherever the extent begins. Error: it lies
/// beyond all numbers.
Expected<Transform> placeOf(const VtiFile &file, const SampleBox &box, bool ofCells,
                            std::vector<std::string> &warnings) {
  std::array<std::array<double, 3>, 3> steps{};
  std::array<double, 3> first = file.origin;
  bool isFlat = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    isFlat = isFlat || file.spacing[axis] == 0;
    const double spacing = file.spacing[axis] == 0 ? 1 : file.spacing[axis];
    for (std::size_t i = 0; i < 3; ++i) {
      steps[axis][i] = file.direction[3 * i + axis] * spacing;
      first[i] += steps[axis][i] * (static_cast<double>(box.low[axis]) + (ofCells ? 0.5 : 0));
    }
  }
  if (isFlat)
    warnings.push_back("its spacing is 0 along an axis, and is taken as 1");
  const Transform map = mapOfSteps(steps, first);
  for (const double number : rowsOf(map))
    if (!std::isfinite(number))
      return Error::input("its Origin, Spacing and Direction together lead beyond all numbers");
  return map;
}

void tellFields(const VtiFile &file, std::vector<std::string> &warnings) {
  std::string names;
  for (const std::string &name : file.fieldArrays)
    names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    warnings.push_back("its field data are left out: " + names.substr(0, 400));
}

} // namespace

Expected<DenseVolume> readVtkImage(const VtiFile &file, std::shared_ptr<const WatchedFile> source,
                                   const InputOptions &options) {
  VOXC_TRY(checkTiles(file));
  DenseVolume volume;
  const auto chosen = VOXC_TRY(chooseArray(file, options, volume.warnings));
  const VtkArray &array = file.pieces.front().arrays[chosen];
  const auto box = VOXC_TRY(boxOf(file.whole, array.isOfCells));
  for (int axis = 0; axis < 3; ++axis)
    volume.extent[axis] = static_cast<std::int32_t>(box.size[static_cast<std::size_t>(axis)]);
  volume.layout.type = *array.type;
  VOXC_TRY(sampleBytes(volume.extent, volume.layout));
  constexpr std::int64_t kMostComponents = 1024;
  constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 48;
  if (box.count() > kMostSamples)
    return Error::input("its extent " + toText(file.whole) + " has more samples than any file");
  if (array.components > kMostComponents)
    return Error::input("its array '" + called(array) + "' has " + std::to_string(array.components) +
                        " components; there may be " + std::to_string(kMostComponents));
  const bool areColours = (array.components == 3 || array.components == 4) &&
                          *array.type == SampleType::Uint8 && options.volume == 0;
  const auto size = static_cast<std::int64_t>(byteSize(*array.type));
  std::uint64_t component = 0;
  if (!areColours) {
    component =
        VOXC_TRY(chooseVolume(static_cast<std::uint64_t>(array.components), options, volume.warnings));
  }
  const std::int64_t cell = size * array.components;
  auto numbers = VOXC_TRY(readPieces(file, array, box, static_cast<std::size_t>(cell), options));
  volume.layout.bigEndian = numbers.isBigEndian;
  volume.samples = numbers.first + static_cast<std::int64_t>(component) * size;
  volume.storage = numbers.storage ? std::move(numbers.storage) : std::move(source);
  if (array.components > 1)
    volume.steps = {cell, cell * volume.extent.x, cell * volume.extent.x * volume.extent.y};
  if (areColours) {
    volume.channels = static_cast<int>(array.components);
    volume.channelStep = size;
  }
  volume.sampleToModel = VOXC_TRY(placeOf(file, box, array.isOfCells, volume.warnings));
  tellFields(file, volume.warnings);
  return volume;
}

} // namespace voxc
