// Fuzzes the reader of .gltf and .glb files: the content says which.
#include "FuzzedFile.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  static const std::string buffer = folder().write("b.bin", std::string(256, '\x3f'));
  loadAndUse(folder().write("m.gltf", textOf(data, size)));
  return 0;
}
