// Colours voxel by voxel; those that repeat the one before are counted together.
#include "ColourTally.h"

#include <bit>

namespace voxc {

namespace {

ChannelFacts factsOf(const std::array<std::uint64_t, 256> &histogram) {
  ChannelFacts facts{256, 0, 0};
  double sum = 0;
  double weighted = 0;
  for (int value = 0; value < 256; ++value) {
    const std::uint64_t count = histogram[static_cast<std::size_t>(value)];
    if (count == 0)
      continue;
    facts.least = std::min(facts.least, value);
    facts.greatest = value;
    sum += static_cast<double>(count);
    weighted += static_cast<double>(count) * value;
  }
  facts.mean = weighted / sum;
  return facts;
}

} // namespace

ColourTally::ColourTally(std::size_t mostWords) : counts_(mostWords), words_(mostWords), rgb_(mostWords) {}

void ColourTally::add(const Brick &brick) {
  inBlock8_.start();
  bool isFirst = true;
  for (unsigned part = 0; part < 8; ++part) {
    if (brick.masks[part] == 0)
      continue;
    inBlock4_.start();
    isFirst = true;
    for (std::uint64_t left = brick.masks[part]; left != 0; left &= left - 1) {
      add(brick.words[64 * part + static_cast<unsigned>(std::countr_zero(left))], isFirst);
      isFirst = false;
    }
  }
}

/// Adds a voxel; `isFirst`: of a block of 4^3.
void ColourTally::add(std::uint32_t word, bool isFirst) {
  const bool startsRun = voxels_++ % kRun == 0;
  if (startsRun)
    inRun_.start();
  if (word == last_ && !isFirst && !startsRun) {
    ++repeated_;
    return;
  }
  inBlock4_.add(word);
  inBlock8_.add(word);
  inRun_.add(word);
  if (word != last_) {
    endRepeats();
    ++changes_;
    last_ = word;
  }
  ++repeated_;
}

void ColourTally::endRepeats() {
  if (repeated_ == 0)
    return;
  if (counts_.add(last_, repeated_)) {
    words_.insert(last_);
    rgb_.insert((last_ & 0xffffff) + 1);
  }
  for (unsigned channel = 0; channel < 4; ++channel)
    histograms_[channel][last_ >> 8 * channel & 0xff] += repeated_;
  repeated_ = 0;
}

ColourFacts ColourTally::finish() {
  endRepeats();
  ColourFacts facts;
  if (voxels_ == 0)
    return facts;
  facts.words = words_.count();
  facts.rgb = rgb_.count();
  facts.entropy = counts_.entropy();
  facts.entropyExact = counts_.exact();
  for (std::size_t channel = 0; channel < histograms_.size(); ++channel)
    facts.channels[channel] = factsOf(histograms_[channel]);
  const std::array<std::uint64_t, 256> &alphas = histograms_.back();
  facts.alphas = static_cast<int>(alphas.size() - static_cast<std::size_t>(std::ranges::count(alphas, 0u)));
  facts.opaque = alphas.back();
  facts.transparent = alphas.front();
  facts.repeats = voxels_ - changes_;
  facts.perBlock4 = inBlock4_.mean();
  facts.perBlock8 = inBlock8_.mean();
  facts.perRun256 = inRun_.mean();
  return facts;
}

} // namespace voxc
