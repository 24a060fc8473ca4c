// The facts of a source as lines and tables.
#include "choosing/FactsFigures.h"

#include "voxc/Facts/Recommendations.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdarg>
#include <cstdio>

namespace voxc::tool {

namespace {

/// Text that grows by printf.
class Report {
public:
  [[gnu::format(printf, 2, 3)]] void print(const char *format, ...) {
    std::array<char, 512> line;
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line.data(), line.size(), format, arguments);
    va_end(arguments);
    text_ += line.data();
  }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
};

double percentOf(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

/// A number; "~" stands before an estimate.
std::string textOf(const DistinctCount &count) {
  return (count.exact ? "" : "~") + std::to_string(count.count);
}

void printPlace(Report &report, const Facts &facts) {
  const Int3 extent = facts.extent;
  const Int3 box = facts.boxHigh - facts.boxLow;
  report.print("extent      %d x %d x %d voxels, in a cube of 2^%d\n", extent.x, extent.y, extent.z,
               facts.log2Extent);
  report.print("voxels      %" PRIu64 "\n", facts.voxels);
  report.print("box         %d x %d x %d from (%d, %d, %d), %.2f %% full\n", box.x, box.y, box.z,
               facts.boxLow.x, facts.boxLow.y, facts.boxLow.z, 100 * facts.fill());
  report.print("interior    %" PRIu64 " (%.1f %%) have all six neighbours\n", facts.interior,
               100 * facts.interiorShare());
}

void printRegions(Report &report, const Facts &facts) {
  const auto &voxels = facts.regions.voxels;
  const auto densest = static_cast<int>(std::ranges::max_element(voxels) - voxels.begin());
  const std::uint64_t most = voxels[static_cast<std::size_t>(densest)];
  const int log2Side = facts.regions.log2Side;
  report.print("regions     %d of 64 (2^%d a side) are empty; the densest, (%d, %d, %d), has %.1f %% of the "
               "voxels and is %.2f %% full\n",
               static_cast<int>(std::ranges::count(voxels, 0u)), log2Side, densest % 4, densest / 4 % 4,
               densest / 16, percentOf(most, facts.voxels),
               percentOf(most, std::uint64_t{1} << 3 * log2Side));
}

void printColours(Report &report, const Facts &facts) {
  const ColourFacts &colours = facts.colours;
  report.print("colours     %s, %s without alpha; bits a voxel: entropy %s%.2f, index %d\n",
               textOf(colours.words).c_str(), textOf(colours.rgb).c_str(),
               colours.entropyExact ? "" : "at least ", colours.entropy, colours.indexBits());
  report.print("near        %.2f colours in a block of 4^3, %.2f in 8^3, %.2f in 256 voxels in a row; %.1f "
               "%% repeat the one before\n",
               colours.perBlock4, colours.perBlock8, colours.perRun256,
               percentOf(colours.repeats, facts.voxels));
  report.print("channels   ");
  for (std::size_t i = 0; i < colours.channels.size(); ++i) {
    const ChannelFacts &channel = colours.channels[i];
    report.print(" %s %d to %d (mean %.1f)%s", std::array{"R", "G", "B", "A"}[i], channel.least,
                 channel.greatest, channel.mean, i < 3 ? "," : "\n");
  }
  report.print("alpha       different values: %d; %.1f %% of the voxels are opaque, %" PRIu64
               " have an alpha of 0\n",
               colours.alphas, percentOf(colours.opaque, facts.voxels), colours.transparent);
}

/// Aligned cubes by their side, and how many blocks differ where that was counted.
void printHeights(Report &report, const Facts &facts) {
  report.print("\n%6s %12s %8s %8s %10s %8s %12s %12s %12s\n", "side", "cubes", "children", "full %",
               "1 colour %", "both %", "shapes", "mirrored", "coloured");
  for (std::size_t height = facts.heights.size(); height-- > 0;) {
    const HeightFacts &cubes = facts.heights[height];
    report.print("%6s %12" PRIu64, ("2^" + std::to_string(height)).c_str(), cubes.occupied);
    if (height == 0) {
      report.print("\n");
      continue;
    }
    report.print(" %8.2f %8.2f %10.2f %8.2f", facts.branching(static_cast<int>(height)),
                 percentOf(cubes.full, cubes.occupied), percentOf(cubes.oneColour, cubes.occupied),
                 percentOf(cubes.uniform, cubes.occupied));
    if (height <= facts.repetition.size()) {
      const RepetitionFacts &blocks = facts.repetition[height - 1];
      report.print(" %12s %12s %12s", textOf(blocks.shapes).c_str(), textOf(blocks.mirrored).c_str(),
                   textOf(blocks.coloured).c_str());
    }
    report.print("\n");
  }
}

} // namespace

std::string factsReport(const Facts &facts) {
  Report report;
  printPlace(report, facts);
  if (facts.voxels > 0) {
    printRegions(report, facts);
    printColours(report, facts);
    printHeights(report, facts);
  }
  report.print("\nWhat follows\n");
  for (const Recommendation &recommendation : recommend(facts))
    report.print("  - %s\n", recommendation.text.c_str());
  return report.take();
}

} // namespace voxc::tool
