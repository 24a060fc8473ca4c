// Points of LAS files, decoded where they lie.
#include "Input/Las/LasFile.h"
#include "Input/Las/LasNumbers.h"
#include "Support/Text.h"

#include <algorithm>
#include <string>
#include <utility>

namespace voxc {

namespace {

constexpr std::uint64_t kLasPointsBetweenLooks = 1 << 12;
constexpr std::size_t kIntensity = 12, kOldFlags = 15, kNewFlags = 15;
constexpr unsigned kOldWithheld = 0x80, kNewWithheld = 0x04;

/// Where red, green and blue lie in each format; 0: it has none.
constexpr std::array<std::size_t, 11> kColours{0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};

/// What each format has beside a place, an intensity and a colour.
constexpr std::array<std::string_view, 11> kBeside{"",
                                                   ", times",
                                                   "",
                                                   ", times",
                                                   ", times, waveforms",
                                                   ", times, waveforms",
                                                   ", times",
                                                   ", times",
                                                   ", times, near infrared",
                                                   ", times, waveforms",
                                                   ", times, near infrared, waveforms"};
constexpr std::array<std::uint64_t, 11> kFormatEnds{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

std::uint32_t opaque(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return red | green << 8 | blue << 16 | 0xff000000;
}

class LasPoints final : public PointList {
public:
  explicit LasPoints(const LasHeader &header) : header_(header), colour_(kColours[header.format]) {}

  /// Finds out how bright colours and intensities are. Error: interrupted.
  Expected<void> look(WorkingMemory &memory, const Progress &progress) {
    std::vector<std::uint64_t> intensities(1 << 16);
    for (std::uint64_t i = 0; i < header_.count; ++i) {
      if (i % kLasPointsBetweenLooks == 0) {
        VOXC_TRY(progress.check());
        memory.relieve(kLasPointsBetweenLooks * header_.stride);
      }
      const auto row = rowOf(i);
      ++intensities[lasNumber<std::uint16_t>(row, kIntensity)];
      for (std::size_t channel = 0; channel < 3 && colour_ > 0; ++channel)
        brightest_ = std::max(brightest_, lasNumber<std::uint16_t>(row, colour_ + 2 * channel));
    }
    findGreys(intensities);
    return {};
  }

  std::uint64_t size() const override { return header_.count; }
  bool hasColours() const override { return brightest_ > 0 || low_ < high_; }
  std::string saysDropped(std::uint64_t count) const override {
    return countedAre(count, "point") + " left out, withheld as the file says";
  }

  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = rowOf(first + i);
      for (std::size_t axis = 0; axis < 3; ++axis)
        points[i].position[axis] =
            lasNumber<std::int32_t>(row, 4 * axis) * header_.scale[axis] + header_.offset[axis];
      points[i].word = isWithheld(row) ? 0 : wordOf(row);
    }
  }

  std::vector<std::string> warnings() const override {
    std::vector<std::string> sentences;
    if (areBytes())
      sentences.push_back("its colours are at most " + std::to_string(brightest_) +
                          ", and are taken as bytes, though the format has 16 bits");
    if (header_.behind > 0)
      sentences.push_back(countedAre(header_.behind, "byte") + " left out, which lie behind the " +
                          counted(header_.count, "point") + " that its head says");
    if (header_.count == 0)
      return sentences;
    std::string rest = "what else its points have is left out: returns, classes, angles";
    rest += kBeside[header_.format];
    if (brightest_ > 0)
      rest += ", intensities";
    if (header_.stride > kFormatEnds[header_.format])
      rest += ", " + counted(header_.stride - kFormatEnds[header_.format], "byte") + " of their own";
    if (header_.records > 0)
      rest += "; so " + std::string(header_.records == 1 ? "is " : "are ") +
              counted(header_.records, "record") + " of the file, such as its coordinate system";
    sentences.push_back(std::move(rest));
    return sentences;
  }

private:
  std::span<const std::byte> rowOf(std::uint64_t point) const {
    return header_.points.subspan(point * header_.stride, header_.stride);
  }

  bool isWithheld(std::span<const std::byte> row) const {
    const auto flags = std::to_integer<unsigned>(row[header_.isNew() ? kNewFlags : kOldFlags]);
    return (flags & (header_.isNew() ? kNewWithheld : kOldWithheld)) != 0;
  }

  /// Many programs write bytes where the format has 16 bits.
  bool areBytes() const { return brightest_ > 0 && brightest_ < 256; }

  /// Greys go from the least intensity to that above which one in a hundred lies: single mirrors are much
  /// brighter than all else.
  void findGreys(const std::vector<std::uint64_t> &intensities) {
    const std::uint64_t most = header_.count - header_.count / 100;
    std::uint64_t below = 0;
    for (std::uint32_t i = 0; i < intensities.size(); ++i) {
      if (below == 0)
        low_ = i;
      if (below < most && intensities[i] > 0)
        high_ = i;
      below += intensities[i];
    }
  }

  std::uint32_t wordOf(std::span<const std::byte> row) const {
    if (brightest_ > 0) {
      std::array<std::uint32_t, 3> bytes{};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t value = lasNumber<std::uint16_t>(row, colour_ + 2 * i);
        bytes[i] = areBytes() ? value : value >> 8; // A byte times 256, as the format has it, or times 257.
      }
      return opaque(bytes[0], bytes[1], bytes[2]);
    }
    if (low_ >= high_)
      return 0xffffffff;
    const std::uint32_t value =
        std::clamp<std::uint32_t>(lasNumber<std::uint16_t>(row, kIntensity), low_, high_);
    const std::uint32_t grey = ((value - low_) * 255 + (high_ - low_) / 2) / (high_ - low_);
    return opaque(grey, grey, grey);
  }

  LasHeader header_;
  std::size_t colour_;
  std::uint16_t brightest_ = 0;
  std::uint32_t low_ = 0, high_ = 0;
};

} // namespace

Expected<std::unique_ptr<PointList>> readLasPoints(const LasHeader &header, WorkingMemory &memory,
                                                   const Progress &progress) {
  auto points = std::make_unique<LasPoints>(header);
  VOXC_TRY(points->look(memory, progress));
  return std::unique_ptr<PointList>(std::move(points));
}

} // namespace voxc
