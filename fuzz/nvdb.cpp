// Fuzzes the reader of NanoVDB files. A grid takes 300 KB, nearly all of it zeros, so that an input is a list
// of what is not: how many zeros to pass over (3 bytes), how many bytes follow (1 byte), and these.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

#include <algorithm>

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

std::string expand(std::string_view packed) {
  std::string file;
  while (packed.size() >= 4) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::size_t>(static_cast<unsigned char>(packed[i]));
    };
    const std::size_t zeros = byte(0) | byte(1) << 8 | byte(2) << 16;
    const std::size_t count = std::min(byte(3), packed.size() - 4);
    if (file.size() + zeros + count > kMostBytes)
      break;
    file.append(zeros, '\0').append(packed.substr(4, count));
    packed.remove_prefix(4 + count);
  }
  return file;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openNanoVdb(folder().write("m.nvdb", expand(textOf(data, size))), fuzzedOptions()));
  return 0;
}
