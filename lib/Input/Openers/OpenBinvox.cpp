// Opening binvox files: a text header, then runs of equal voxels, y fastest, then z, then x.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "Support/Text.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Stopwatch.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

constexpr std::string_view kBinvoxFile = "binvox file";

/// A bit for each voxel, in the order of the file.
using Bits = ScratchArray<std::uint64_t>;

struct BinvoxHeader {
  Int3 extent;
  std::array<double, 3> translation{};
  double scale = 1;
  std::vector<std::string> warnings;
};

class BitRows final : public DenseRows {
public:
  BitRows(Int3 extent, std::shared_ptr<const Bits> bits) : extent_(extent), bits_(std::move(bits)) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    const Int3 order{extent_.y, extent_.z, extent_.x};
    for (std::int32_t i = 0; i < count; ++i) {
      const std::uint64_t bit = cellNumber(order, {first.y, first.z, first.x + i});
      words[i] = (*bits_)[bit / 64] >> bit % 64 & 1 ? 0xffffffff : 0;
    }
  }

private:
  Int3 extent_;
  std::shared_ptr<const Bits> bits_;
};

/// Takes the first word off the front of `line`, as a number that is finite.
bool takeNumber(std::string_view &line, double &number) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const auto parsed = std::from_chars(line.data(), line.data() + line.size(), number);
  line.remove_prefix(static_cast<std::size_t>(parsed.ptr - line.data()));
  return parsed.ec == std::errc() && std::isfinite(number);
}

constexpr std::size_t kMostUnknown = 4;

bool readLine(std::string_view line, BinvoxHeader &header) {
  const std::string_view name = line.substr(0, line.find(' '));
  line.remove_prefix(name.size());
  if (name == "dim") {
    // In the order x, z, y; all are equal in what binvox itself writes.
    std::array<double, 3> sizes{};
    for (double &size : sizes)
      if (!takeNumber(line, size) || size < 0 || size > 1 << (kMaxLog2Extent + 1))
        return false;
    header.extent = {static_cast<int>(sizes[0]), static_cast<int>(sizes[2]), static_cast<int>(sizes[1])};
    return true;
  }
  if (name == "translate")
    return takeNumber(line, header.translation[0]) && takeNumber(line, header.translation[1]) &&
           takeNumber(line, header.translation[2]);
  if (name == "scale")
    return takeNumber(line, header.scale);
  if (!name.empty() && !name.starts_with('#') && header.warnings.size() < kMostUnknown)
    header.warnings.push_back("its line '" + std::string(name.substr(0, 40)) +
                              "' is not known, and is left out");
  return true;
}

/// Reads up to and including the line "data", and takes that off the front of `text`.
Expected<BinvoxHeader> readHeader(std::string_view &text) {
  if (!text.starts_with("#binvox 1"))
    return Error::input("it does not begin with '#binvox 1'");
  BinvoxHeader header;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    if (line == "data") {
      VOXC_TRY(checkGridExtent(header.extent));
      return header;
    }
    if (!readLine(line, header))
      return Error::input("its line '" + std::string(line.substr(0, 80)) + "' makes no sense");
  }
  return Error::input("no line 'data' ends its header");
}

void setBits(std::span<std::uint64_t> bits, std::uint64_t begin, std::uint64_t end) {
  while (begin < end) {
    const std::uint64_t count = std::min(end - begin, 64 - begin % 64);
    const std::uint64_t ones = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    bits[begin / 64] |= ones << begin % 64;
    begin += count;
  }
}

Expected<void> readRuns(std::string_view runs, std::uint64_t cells, Bits &bits, const InputOptions &options,
                        std::vector<std::string> &warnings) {
  // A run takes two bytes and stands for 255 voxels at most.
  if (cells / 255 > runs.size() / 2)
    return Error::input("its " + std::to_string(runs.size()) + " bytes of runs cannot hold " +
                        std::to_string(cells) + " voxels");
  VOXC_TRY(bits.resize(cells / 64 + 1));
  std::uint64_t done = 0;
  bool hasOther = false;
  for (; runs.size() >= 2 && done < cells; runs.remove_prefix(2)) {
    const std::uint64_t count = static_cast<unsigned char>(runs[1]);
    if (count > cells - done)
      return Error::input("its last run reaches over its end");
    hasOther |= runs[0] != 0 && runs[0] != 1;
    if (runs[0] != 0)
      setBits(bits.span(), done, done + count);
    done += count;
    if (runs.size() % (1 << 16) < 2) {
      VOXC_TRY(options.progress.check());
      options.memory->relieve();
    }
  }
  if (done < cells)
    return Error::input("its runs end after " + std::to_string(done) + " of " + std::to_string(cells) +
                        " voxels");
  if (hasOther)
    warnings.emplace_back("its runs have other numbers than 0 and 1, all of which are taken for voxels");
  if (!runs.empty())
    warnings.push_back(countedAre(runs.size(), "byte") + " left out, which lie behind the last voxel");
  return {};
}

/// A voxel's side is the scale over the voxels of an axis.
Transform mapOf(const BinvoxHeader &header) {
  const double unit = header.scale / longestAxis(header.extent);
  const auto [x, y, z] = header.translation;
  return transformOfRows({unit, 0, 0, x, 0, unit, 0, y, 0, 0, unit, z});
}

std::vector<InputFact> factsOf(const BinvoxHeader &header, const Bits &bits) {
  std::uint64_t voxels = 0;
  for (const std::uint64_t word : bits.span())
    voxels += static_cast<std::uint64_t>(std::popcount(word));
  return {sizeFact("size", header.extent),
          countFact("voxels", voxels),
          {"scale", toText(header.scale), {header.scale}}};
}

} // namespace

Expected<Input> openBinvox(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  std::string_view text = file->text();
  auto header = VOXC_TRY(usable(readHeader(text), path, kBinvoxFile));
  const Int3 extent = header.extent;
  auto bits = std::make_shared<Bits>(options.memory);
  VOXC_TRY(usable(readRuns(text, cellsOf(extent), *bits, options, header.warnings), path, kBinvoxFile));
  Input input;
  if (options.describe)
    input.facts = factsOf(header, *bits);
  input.source = VOXC_TRY(makeUprightSource(extent, std::make_shared<BitRows>(extent, std::move(bits)),
                                            mapOf(header), options.zUp, options.memory, options.progress));
  input.warnings = std::move(header.warnings);
  input.loadSeconds = loading.seconds();
  input.provenance = "coverage=voxels" + upProvenance(options);
  return input;
}

} // namespace voxc
