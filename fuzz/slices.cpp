// Fuzzes the reader of slices: the content is that of two pictures, of which the second is cut off by a few
// bytes.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  const std::string_view text = textOf(data, size);
  folder().write("s0.png", text);
  const std::string second = folder().write("s1.png", text.substr(0, size - size % 3));
  readVoxels(voxc::openSlices(second.substr(0, second.size() - 5) + "%d.png", fuzzedOptions()));
  return 0;
}
