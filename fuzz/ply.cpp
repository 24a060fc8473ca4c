// Fuzzes the reader of .ply files with faces.
#include "FuzzedFile.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  loadAndUse(folder().write("m.ply", textOf(data, size)));
  return 0;
}
