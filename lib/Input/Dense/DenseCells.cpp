// Rows of dense volumes by the steps between their samples.
#include "Input/Dense/DenseCells.h"

#include "Source/GridExtent.h"
#include "voxc/Source/VoxelSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace voxc {

namespace {

/// Samples that are taken at once.
constexpr std::size_t kSome = 256;

std::int64_t offsetOf(const std::array<std::int64_t, 3> &steps, Int3 cell) {
  return steps[0] * cell.x + steps[1] * cell.y + steps[2] * cell.z;
}

class SampleRows final : public DenseRows {
public:
  SampleRows(DenseVolume volume, const SampleMap &map)
      : volume_(std::move(volume)), map_(map), steps_(stepsOf(volume_)) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    const std::size_t bytes = byteSize(volume_.layout.type);
    const std::byte *at = volume_.samples + offsetOf(steps_, first);
    if (steps_[0] == static_cast<std::int64_t>(bytes))
      return mapSamples(volume_.layout, at, static_cast<std::size_t>(count), map_, words);
    std::array<std::byte, kSome * 8> some;
    for (auto left = static_cast<std::size_t>(count); left > 0;) {
      const std::size_t now = std::min(left, kSome);
      gatherSamples(at, steps_[0], now, bytes, some.data());
      mapSamples(volume_.layout, some.data(), now, map_, words);
      words += now;
      left -= now;
      at += steps_[0] * static_cast<std::int64_t>(now);
    }
  }

private:
  DenseVolume volume_;
  SampleMap map_;
  std::array<std::int64_t, 3> steps_;
};

/// 0 to 255 of a channel's value, which is 255 at `most`.
std::uint32_t byteOf(double value, double most) {
  // In this order NaN becomes 0.
  return static_cast<std::uint32_t>(std::lround(255 * std::max(0.0, std::min(value / most, 1.0))));
}

class ColourRows final : public DenseRows {
public:
  explicit ColourRows(DenseVolume volume) : volume_(std::move(volume)), steps_(stepsOf(volume_)) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    const std::byte *at = volume_.samples + offsetOf(steps_, first);
    for (std::int32_t i = 0; i < count; ++i, at += steps_[0])
      words[i] = wordAt(at);
  }

private:
  std::uint32_t wordAt(const std::byte *at) const {
    std::array<std::uint32_t, 4> bytes{0, 0, 0, 255};
    for (int channel = 0; channel < volume_.channels; ++channel) {
      double value = 0;
      loadSamples(volume_.layout, at + channel * volume_.channelStep, 1, &value);
      bytes[static_cast<std::size_t>(channel)] =
          byteOf(value, channel < 3 ? volume_.fullColour : volume_.fullAlpha);
    }
    const bool isEmpty = volume_.channels == 3 && (bytes[0] | bytes[1] | bytes[2]) == 0;
    return isEmpty ? 0 : rgba(bytes[0], bytes[1], bytes[2], bytes[3]);
  }

  DenseVolume volume_;
  std::array<std::int64_t, 3> steps_;
};

constexpr std::size_t kPiece = 1 << 14;

/// The samples of a volume that has no gaps.
Expected<void> forEachRun(const DenseVolume &volume, const InputOptions &options, const PieceVisitor &visit) {
  const std::uint64_t count = cellsOf(volume.extent);
  const std::uint64_t bytes = byteSize(volume.layout.type);
  for (std::uint64_t done = 0; done < count; done += kPiece) {
    VOXC_TRY(options.progress.check());
    visit(volume.samples + done * bytes,
          static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, count - done)));
    options.memory->relieve();
  }
  return {};
}

/// The samples along one axis, from `cell` on.
void visitRow(const DenseVolume &volume, int axis, Int3 cell, std::vector<std::byte> &gathered,
              const PieceVisitor &visit) {
  const std::array<std::int64_t, 3> steps = stepsOf(volume);
  const std::size_t bytes = byteSize(volume.layout.type);
  for (auto left = static_cast<std::size_t>(volume.extent[axis]); left > 0;) {
    const std::size_t now = std::min(left, kPiece);
    gatherSamples(volume.samples + offsetOf(steps, cell), steps[static_cast<std::size_t>(axis)], now, bytes,
                  gathered.data());
    visit(gathered.data(), now);
    cell[axis] += static_cast<std::int32_t>(now);
    left -= now;
  }
}

} // namespace

void gatherSamples(const std::byte *first, std::int64_t step, std::size_t count, std::size_t sampleBytes,
                   std::byte *target) {
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(target + i * sampleBytes, first + static_cast<std::int64_t>(i) * step, sampleBytes);
}

Expected<void> forEachPiece(const DenseVolume &volume, const InputOptions &options,
                            const PieceVisitor &visit) {
  if (volume.steps == std::array<std::int64_t, 3>{})
    return forEachRun(volume, options, visit);
  // The axis along which samples lie nearest is gone along first.
  const std::array<std::int64_t, 3> steps = stepsOf(volume);
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](int axis) {
    return volume.extent[axis] == 1 ? INT64_MAX : std::abs(steps[static_cast<std::size_t>(axis)]);
  });
  std::vector<std::byte> gathered(kPiece * byteSize(volume.layout.type));
  Int3 cell;
  for (cell[order[2]] = 0; cell[order[2]] < volume.extent[order[2]]; ++cell[order[2]])
    for (cell[order[1]] = 0; cell[order[1]] < volume.extent[order[1]]; ++cell[order[1]]) {
      VOXC_TRY(options.progress.check());
      visitRow(volume, order[0], cell, gathered, visit);
      options.memory->relieve();
    }
  return {};
}

std::shared_ptr<const DenseRows> makeRows(DenseVolume volume, const SampleMap &map) {
  if (volume.channels > 1)
    return std::make_shared<ColourRows>(std::move(volume));
  return std::make_shared<SampleRows>(std::move(volume), map);
}

} // namespace voxc
