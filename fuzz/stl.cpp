// Fuzzes the reader of .stl files, binary and text.
#include "FuzzedFile.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  loadAndUse(folder().write("m.stl", textOf(data, size)));
  return 0;
}
