// Axes of NRRD files: of space, of colours, and others.
#include "Input/Dense/NrrdAxes.h"

#include "Input/Dense/DenseVolume.h"
#include "Source/GridExtent.h"

#include <algorithm>

namespace voxc {

namespace {

constexpr std::int64_t kMost = (std::int64_t{1} << kMaxLog2Extent) + 1;

bool isSpatialKind(std::string_view kind) { return kind == "domain" || kind == "space"; }
bool isColourKind(std::string_view kind) {
  return kind == "rgb-color" || kind == "rgba-color" || kind == "3-color" || kind == "4-color";
}
/// Whether a kind says that an axis is none of space.
bool isOtherKind(std::string_view kind) {
  return !kind.empty() && kind != "???" && kind != "none" && !isSpatialKind(kind);
}

/// The axes one by one, and what is known of each.
class Axes {
public:
  explicit Axes(const NrrdFields &fields)
      : fields_(fields), count_(fields.sizes.size()), areSpatial_(count_) {
    for (std::size_t axis = 0; axis < count_; ++axis)
      areSpatial_[axis] = isSpatial(axis);
    leaveThree();
  }

  std::string kind(std::size_t axis) const {
    return axis < fields_.kinds.size() && fields_.kinds.size() == count_ ? fields_.kinds[axis] : "";
  }
  bool isOfSpace(std::size_t axis) const { return areSpatial_[axis]; }
  /// Nothing but the order of the axes says which are those of space.
  bool isGuessed() const { return isGuessed_; }

private:
  bool isSpatial(std::size_t axis) const {
    // Three axes are a volume, whatever they are called, unless one is said to be colours.
    if (fields_.directions.size() == count_)
      return !fields_.directions[axis].empty();
    return count_ <= 3 ? !isColourKind(kind(axis)) : !isOtherKind(kind(axis));
  }

  /// Of more than three axes that may be of space leaves three.
  void leaveThree() {
    const auto several = [&] { return std::ranges::count(areSpatial_, true) > 3; };
    for (std::size_t axis = 0; axis < count_ && several(); ++axis)
      if (fields_.sizes[axis] == 1)
        areSpatial_[axis] = false;
    isGuessed_ = several();
    // A few components come first, as most programs write them; times and the like come last.
    constexpr std::int64_t kMostComponents = 4;
    if (several() && fields_.sizes[0] <= kMostComponents)
      areSpatial_[0] = false;
    for (std::size_t axis = count_; axis-- > 0 && several();)
      areSpatial_[axis] = false;
  }

  const NrrdFields &fields_;
  std::size_t count_;
  std::vector<bool> areSpatial_;
  bool isGuessed_ = false;
};

/// Whether an axis that is none of space has the channels of colours.
bool hasChannels(const NrrdFields &fields, const Axes &axes, std::size_t axis) {
  const std::int64_t size = fields.sizes[axis];
  if (size != 3 && size != 4)
    return false;
  const std::string kind = axes.kind(axis);
  if (isColourKind(kind))
    return true;
  // Bytes by threes are colours to those who write them, unless they are layers of segments, or times.
  return *fields.type == SampleType::Uint8 && !fields.hasSegments && kind != "time" && kind != "hsv-color" &&
         kind != "xyz-color";
}

Expected<void> checkSizes(const NrrdFields &fields) {
  const std::size_t count = fields.sizes.size();
  if (fields.dimension.value_or(0) != static_cast<std::int64_t>(count) || count < 1 || count > 16)
    return Error::input("it has " + std::to_string(count) + " sizes, but its dimension is " +
                        std::to_string(fields.dimension.value_or(0)) + "; both should be the same, 1 to 16");
  return {};
}

/// Places the axes; false if all of them have more samples than any file.
bool placeAxes(const NrrdFields &fields, const Axes &axes, bool picksVolume, NrrdHeader &header,
               std::array<int, 3> &order) {
  int found = 0;
  auto step = static_cast<std::int64_t>(byteSize(*fields.type));
  bool isPossible = true;
  for (std::size_t axis = 0; axis < fields.sizes.size(); ++axis) {
    const std::int64_t size = std::max<std::int64_t>(fields.sizes[axis], 0);
    if (axes.isOfSpace(axis)) {
      order[static_cast<std::size_t>(found)] = static_cast<int>(axis);
      header.extent[found] = static_cast<std::int32_t>(std::min(size, kMost));
      header.steps[static_cast<std::size_t>(found++)] = step;
    } else if (header.channels == 1 && !picksVolume && hasChannels(fields, axes, axis)) {
      header.channels = static_cast<int>(size);
      header.channelStep = step;
    } else {
      header.others.push_back({static_cast<std::uint64_t>(size), step});
    }
    isPossible = isPossible && size > 0 && step <= (std::int64_t{1} << 62) / size;
    step = isPossible ? step * size : step;
  }
  // Axes that are not there have one sample.
  for (; found < 3; ++found)
    header.steps[static_cast<std::size_t>(found)] = step;
  header.bytes = static_cast<std::uint64_t>(step);
  return isPossible;
}

void tellOthers(const NrrdFields &fields, const Axes &axes, NrrdHeader &header) {
  if (axes.isGuessed())
    header.notes.push_back("its field kinds does not say which of its " +
                           std::to_string(fields.sizes.size()) +
                           " axes are those of space; the volume is taken as " + extentText(header.extent));
  if (header.channels > 1)
    header.notes.push_back("an axis of " + std::to_string(header.channels) +
                           " is taken for the channels of colours (--volume 1 takes the first alone)");
}

} // namespace

Expected<void> fillAxes(const NrrdFields &fields, bool picksVolume, NrrdHeader &header,
                        std::array<int, 3> &order) {
  VOXC_TRY(checkSizes(fields));
  const Axes axes(fields);
  order = {-1, -1, -1};
  header.extent = {1, 1, 1};
  const bool isPossible = placeAxes(fields, axes, picksVolume, header, order);
  VOXC_TRY(sampleBytes(header.extent, header.layout));
  if (!isPossible)
    return Error::input("its sizes make no samples at all, or more than any file has");
  tellOthers(fields, axes, header);
  return {};
}

} // namespace voxc
