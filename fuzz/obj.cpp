// Fuzzes the reader of .obj files and of their material libraries: what follows a line "#mtl" is the library
// m.mtl.
#include "FuzzedFile.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  constexpr std::string_view kMark = "#mtl\n";
  const std::string_view text = textOf(data, size);
  const std::size_t mark = text.find(kMark);
  folder().write("m.mtl",
                 mark == std::string_view::npos ? std::string_view() : text.substr(mark + kMark.size()));
  loadAndUse(folder().write("m.obj", text.substr(0, mark)));
  return 0;
}
