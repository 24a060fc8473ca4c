// Fuzzes the readers of Minecraft's schematics. What gzip packed is tried as it is inflated.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openMinecraft(folder().write("m.schem", textOf(data, size)), fuzzedOptions()));
  return 0;
}
