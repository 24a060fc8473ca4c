// Fuzzes the structure check, lookups and decoding: a format's text up to a line feed, then words. The file
// around them would be refused by its checksum.
#include "FuzzedFile.h"

#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace {

using namespace voxc;

/// What was found sound must decode to as many voxels as were counted, and lookups must find them.
void decodeAll(const Format &format, const std::vector<std::uint32_t> &words, std::uint64_t voxels) {
  VolumeInfo info;
  info.format = format;
  info.extent = format.extent();
  info.voxels = voxels;
  const Volume volume(std::move(info), words);
  std::uint64_t found = 0;
  int cubesLeft = 20000;
  const auto visit = [&](const Cube &cube, std::uint32_t word) {
    found += std::uint64_t{1} << 3 * cube.log2Side;
    if (volume.lookup(cube.low).value != word)
      std::abort();
    return --cubesLeft > 0;
  };
  const auto decoded = decode(volume, visit);
  if (!decoded || (cubesLeft > 0 && found != voxels))
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string_view text = fuzz::textOf(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const auto format = parseFormat(text.substr(0, end));
  if (!format)
    return 0;
  const std::string_view rest = text.substr(std::min(end + 1, text.size()));
  std::vector<std::uint32_t> words(rest.size() / 4);
  std::copy_n(rest.data(), words.size() * 4, reinterpret_cast<char *>(words.data()));
  if (const auto voxels = checkStructure(*format, words))
    decodeAll(*format, words, *voxels);
  return 0;
}
