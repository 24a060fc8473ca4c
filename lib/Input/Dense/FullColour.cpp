// Guessing by the numbers that there are.
#include "Input/Dense/FullColour.h"

#include "Input/Dense/DenseCells.h"
#include "Input/Openers/InputText.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace voxc {

namespace {

constexpr double kByteColours = 255, kWideColours = 65535;

/// Of some channels; what is no finite number is left out.
struct ChannelRange {
  double high = 0;
  bool areWhole = true;
  std::uint64_t shares = 0, others = 0; ///< Numbers above 0, up to 1 and above.

  void add(double value) {
    if (!std::isfinite(value))
      return;
    high = std::max(high, value);
    areWhole &= value == std::floor(value);
    shares += value > 0 && value <= 1 ? 1 : 0;
    others += value > 1 ? 1 : 0;
  }
};

Expected<ChannelRange> rangeOfChannels(const DenseVolume &volume, int first, int end,
                                       const InputOptions &options) {
  ChannelRange range;
  DenseVolume channel = volume;
  channel.channels = 1;
  channel.steps = stepsOf(volume);
  channel.samples += first * volume.channelStep;
  std::vector<double> stored;
  for (int i = first; i < end; ++i, channel.samples += volume.channelStep)
    VOXC_TRY(forEachPiece(channel, options, [&](const std::byte *samples, std::size_t count) {
      stored.resize(count);
      loadSamples(volume.layout, samples, count, stored.data());
      for (const double value : stored)
        range.add(value);
    }));
  return range;
}

/// The greatest number of a type, or 1.
double mostOf(SampleType type) { return isWhole(type) ? greatest(type) : 1; }

double fullOf(SampleType type, const ChannelRange &range) {
  const double most = mostOf(type);
  if (!isWhole(type) && range.high <= 1)
    return most;
  // Means of bytes are not whole.
  if (range.high <= kByteColours && (range.areWhole || range.others > range.shares))
    return kByteColours;
  return most > kWideColours && range.high <= kWideColours ? kWideColours : most;
}

void tellColours(DenseVolume &volume, const ChannelRange &range) {
  constexpr double kDark = 0.1; // Of the most that there may be.
  const double most = mostOf(volume.layout.type);
  const std::string found = "its colours go up to " + toText(range.high);
  if (volume.fullColour != most)
    volume.warnings.push_back(found + ", and are taken as " +
                              (volume.fullColour == kByteColours ? "bytes" : "numbers of 16 bits") +
                              ", though the type is " + toText(volume.layout));
  else if (range.high > most)
    volume.warnings.push_back(found + ", and those above 1 are taken as 1");
  else if (isWhole(volume.layout.type) && range.high > 0 && range.high < kDark * most)
    volume.warnings.push_back(found + " of " + toText(most) + ", and are nearly black");
}

} // namespace

Expected<void> findFullColour(DenseVolume &volume, const InputOptions &options) {
  const SampleType type = volume.layout.type;
  volume.fullColour = volume.fullAlpha = mostOf(type);
  if (isWhole(type) && volume.fullColour <= kByteColours)
    return {};
  constexpr int kColours = 3;
  const auto colours = VOXC_TRY(rangeOfChannels(volume, 0, kColours, options));
  volume.fullColour = fullOf(type, colours);
  tellColours(volume, colours);
  const auto alpha = VOXC_TRY(rangeOfChannels(volume, kColours, volume.channels, options));
  volume.fullAlpha = alpha.high <= 1 ? 1 : fullOf(type, alpha);
  return {};
}

} // namespace voxc
