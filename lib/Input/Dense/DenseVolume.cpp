// Dense volumes as inputs.
#include "Input/Dense/DenseVolume.h"

#include "Input/Dense/ColourMap.h"
#include "Input/Dense/DenseCells.h"
#include "Input/Dense/DenseFacts.h"
#include "Input/Dense/FullColour.h"
#include "Input/Dense/Histogram.h"
#include "Input/Dense/Labels.h"
#include "Input/Dense/Resample.h"
#include "Input/Dense/SampleChecks.h"
#include "Input/Openers/InputText.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

/// From the least to the greatest value that is finite.
Expected<SampleRange> rangeOf(const DenseVolume &volume, const SampleMap &map, const InputOptions &options) {
  SampleRange range;
  const auto looked = forEachPiece(volume, options, [&](const std::byte *samples, std::size_t count) {
    addToRange(volume.layout, samples, count, map, range);
  });
  if (!looked)
    return looked.error();
  return range.low <= range.high ? range : SampleRange{0, 0};
}

/// A share of the samples that no thing in a box fills, with room around it.
constexpr double kMostlySolid = 0.5;

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// Finds the threshold that nobody gave, if too much would be solid without, and says what it is. Labels have
/// none: a histogram parts what is measured, and would drop some of them. Nor have samples of a file that
/// says by no numbers where nothing is. Error: interrupted.
Expected<void> findThreshold(DenseVolume &volume, const Histogram &histogram, const InputOptions &options,
                             SampleMap &map) {
  const double share = histogram.shareFrom(histogram.range.low);
  constexpr double kBackground = 0.3; // Of the samples that are not 0: some of them are background then.
  const bool hasBackground = double(histogram.noNumbers) > kBackground * double(histogram.total());
  if (map.threshold || share <= kBackground || hasBackground || histogram.range.low >= histogram.range.high)
    return {};
  const auto labels = VOXC_TRY(countLabels(volume, options));
  if (labels || volume.areLabels) {
    volume.notes.push_back("its samples look like labels" +
                           (labels ? ", " + std::to_string(*labels) + " beside 0" : std::string()) +
                           "; all but 0 are voxels (--threshold takes those from a value up, --colour-map "
                           "labels keeps their numbers)");
    return {};
  }
  map.threshold = histogram.threshold();
  volume.notes.push_back(percent(share) + " of the samples are not 0; those from " + toText(*map.threshold) +
                         " up are taken, which parts them best (--threshold " + toText(*map.threshold) + ")");
  return {};
}

/// Warns of a threshold that parts nothing, or of little that it leaves out.
void warnOfThreshold(DenseVolume &volume, const Histogram &histogram, const SampleMap &map) {
  const std::optional<std::string> complaint =
      map.threshold ? complaintOf(*map.threshold, histogram.range) : std::nullopt;
  double solid = histogram.shareFrom(map.threshold.value_or(histogram.range.low));
  if (map.threshold && *map.threshold <= 0 && histogram.total() > 0)
    solid += double(histogram.zeros) / double(histogram.total());
  if (complaint)
    volume.warnings.push_back(*complaint);
  else if (solid > kMostlySolid)
    volume.warnings.push_back(percent(solid) +
                              " of the samples become voxels; --threshold leaves out those below it");
}

Expected<void> fillWindow(const SampleRange &range, const InputOptions &options, SampleMap &map) {
  if (options.window) {
    const auto [low, high] = *options.window;
    if (!std::isfinite(low) || !std::isfinite(high) || low > high)
      return Error::usage("the window from " + toText(low) + " to " + toText(high) +
                          " is none; its first number must be the lower one");
    map.window = {low, high};
    return {};
  }
  map.window = range;
  if (options.isAutomatic && range.low < range.high) {
    // What is seen lies just above the threshold, and shall not be black: the window begins below.
    constexpr double kDarkest = 0.4; // Of the colours, from the first on.
    const double least = map.threshold && *map.threshold < range.high ? *map.threshold : range.low;
    map.window.low = least - (range.high - least) * kDarkest / (1 - kDarkest);
  }
  return {};
}

/// How samples are kept as they are.
SampleMap::Kept keptAs(const DenseVolume &volume) {
  const bool areWhole = isWhole(volume.layout.type) && volume.slope == std::floor(volume.slope) &&
                        volume.intercept == std::floor(volume.intercept);
  return areWhole ? SampleMap::Kept::Int32 : SampleMap::Kept::Float32;
}

/// What the samples are looked at for; all else is done without.
struct Look {
  bool range = false;
  bool histogram = false;
};

Look lookFor(const InputOptions &options) {
  const bool isColoured = options.colourMap != kLabels && !options.keepsSamples;
  return {options.describe || options.threshold || options.keepsSamples || (isColoured && !options.window),
          options.describe || (options.isAutomatic && isColoured)};
}

Expected<Histogram> lookAt(const DenseVolume &volume, const SampleMap &map, const InputOptions &options) {
  const Look look = lookFor(options);
  Histogram nothing;
  if (!look.range && !look.histogram)
    return nothing;
  const auto range = VOXC_TRY(rangeOf(volume, map, options));
  if (look.histogram)
    return histogramOf(volume, map, range, options);
  nothing.range = range;
  return nothing;
}

Expected<SampleMap> mapOf(DenseVolume &volume, const InputOptions &options, std::vector<InputFact> &facts) {
  VOXC_TRY(checkThreshold(options.threshold));
  SampleMap map{.slope = volume.slope, .intercept = volume.intercept, .threshold = options.threshold};
  const auto histogram = VOXC_TRY(lookAt(volume, map, options));
  if (options.describe)
    facts = factsOf(volume, histogram);
  map.labels = options.colourMap == kLabels;
  if (options.keepsSamples)
    map.kept = keptAs(volume);
  VOXC_TRY(checkKept(map.kept, histogram.range));
  const bool isColoured = !map.labels && !options.keepsSamples;
  if (options.isAutomatic && isColoured)
    VOXC_TRY(findThreshold(volume, histogram, options, map));
  if (map.threshold || (options.isAutomatic && isColoured))
    warnOfThreshold(volume, histogram, map);
  if (!isColoured)
    return map;
  map.colours = VOXC_TRY(colourMap(options.colourMap));
  VOXC_TRY(fillWindow(histogram.range, options, map));
  return map;
}

std::string volumeProvenance(const InputOptions &options) {
  return options.volume > 0 ? " volume=" + std::to_string(options.volume) : "";
}

std::string provenanceOf(const SampleMap &map, const InputOptions &options) {
  std::string text = "coverage=samples";
  if (map.threshold)
    text += " threshold=" + toText(*map.threshold);
  text += " colour-map=" + options.colourMap + volumeProvenance(options);
  if (map.labels)
    return text + upProvenance(options);
  text += " window=" + toText(map.window.low) + "," + toText(map.window.high);
  return text + upProvenance(options);
}

/// Options that mean nothing for colours. Error: one of them is given.
Expected<void> checkColours(const InputOptions &options) {
  const bool isMapped = options.colourMap != "grey" && options.colourMap != kLabels;
  const char *const given = options.threshold ? "--threshold"
                            : options.window  ? "--window"
                            : isMapped        ? "--colour-map"
                                              : nullptr;
  return given ? Error::usage(std::string(given) + " would do nothing for a volume of colours; leave it out")
               : Expected<void>();
}

/// What a volume looks like; `input` gets what is said of it.
Expected<SampleMap> lookOf(DenseVolume &volume, const InputOptions &options, Input &input) {
  if (volume.channels == 1) {
    auto map = mapOf(volume, options, input.facts);
    if (map)
      input.provenance = provenanceOf(*map, options);
    return map;
  }
  VOXC_TRY(checkColours(options));
  VOXC_TRY(findFullColour(volume, options));
  if (options.describe)
    input.facts = factsOf(volume);
  input.provenance = "coverage=cells" + volumeProvenance(options) + upProvenance(options);
  return SampleMap();
}

/// The side of the cubes that are asked for; 0 for the samples as they are. Error: planes shall go through a
/// point, but nothing says how far apart they are.
Expected<double> sideOf(const DenseVolume &volume, const InputOptions &options) {
  auto side = voxelSide(options, volume.unit);
  if (!side || *side > 0 || !options.align)
    return side;
  const auto [x, y, z] = stepLengths(volume.sampleToModel);
  if (std::abs(x - y) <= 1e-6 * x && std::abs(x - z) <= 1e-6 * x)
    return x;
  return Error::usage("--align needs --voxel-size here, since samples are " + byThree({x, y, z}) +
                      " apart and voxels are cubes");
}

} // namespace

std::array<std::int64_t, 3> stepsOf(const DenseVolume &volume) {
  if (volume.steps != std::array<std::int64_t, 3>{})
    return volume.steps;
  const auto bytes = static_cast<std::int64_t>(byteSize(volume.layout.type));
  return {bytes, bytes * volume.extent.x, bytes * volume.extent.x * volume.extent.y};
}

Expected<std::uint64_t> sampleBytes(Int3 extent, SampleLayout layout) {
  VOXC_TRY(checkGridExtent(extent));
  const std::uint64_t cells = cellsOf(extent);
  constexpr std::uint64_t kMost = std::uint64_t{1} << 59;
  if (cells > kMost)
    return Error::input("a grid of " + extentText(extent) + " samples is larger than any file");
  return cells * byteSize(layout.type);
}

Transform mapOfSteps(const std::array<std::array<double, 3>, 3> &steps, const std::array<double, 3> &origin) {
  const auto vector = [](const std::array<double, 3> &v) { return glm::dvec3(v[0], v[1], v[2]); };
  Transform map(vector(steps[0]), vector(steps[1]), vector(steps[2]), vector(origin));
  for (int axis = 0; axis < 3; ++axis)
    map[3] -= map[axis] / 2.0;
  return map;
}

Expected<Input> makeInput(DenseVolume volume, const InputOptions &options) {
  Input input;
  const auto map = VOXC_TRY(lookOf(volume, options, input));
  input.warnings = std::move(volume.warnings);
  input.notes = std::move(volume.notes);
  input.files = std::move(volume.files);
  const auto side = VOXC_TRY(sideOf(volume, options));
  Resampled cells{volume.extent, nullptr, volume.sampleToModel};
  if (side > 0) {
    cells = VOXC_TRY(resample(std::move(volume), map, side, options));
    input.provenance += gridProvenance(side, options);
  } else {
    cells.rows = makeRows(std::move(volume), map);
  }
  if (options.zUp) {
    cells.rows = turnUpright(std::move(cells.rows), cells.extent.y);
    cells.voxelToModel = turnUpright(cells.voxelToModel, cells.extent.y);
    cells.extent = {cells.extent.x, cells.extent.z, cells.extent.y};
  }
  input.source = VOXC_TRY(makeDenseSource(cells.extent, std::move(cells.rows), cells.voxelToModel,
                                          options.memory, options.progress));
  return input;
}

} // namespace voxc
