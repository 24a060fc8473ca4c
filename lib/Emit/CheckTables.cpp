// voxc-check-tables: run when voxc is built. Demands a file, or a class, for each row of each table that
// names one, so that a misspelt name ends the build.
#include "Names.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <cstdio>
#include <string>

namespace voxc {
namespace {

int problems = 0;

void report(const std::string &file, const std::string &problem) {
  std::fprintf(stderr, "%s: %s\n", file.c_str(), problem.c_str());
  ++problems;
}

void demand(const std::string &folder, std::span<const EmbeddedFile> files, const std::string &path) {
  for (const EmbeddedFile &file : files)
    if (file.path == path)
      return;
  report(folder + "/" + path, "is missing, but a table names it");
}

void demand(const RuntimeClass &needed) {
  for (const EmbeddedFile &file : constructHeaders())
    if (needed.name.empty() ||
        (file.path == needed.header &&
         file.text.find("struct " + std::string(needed.name) + " ") != std::string_view::npos))
      return;
  report("construct-runtime/" + std::string(needed.header),
         "has no struct " + std::string(needed.name) + ", which a table names");
}

template <typename Enum> void demandEach(const std::string &folder) {
  for (const std::string_view name : kEnumNames<Enum>)
    demand("shaders-runtime", shaderFiles(), folder + "/" + std::string(name) + ".glsl");
}

} // namespace
} // namespace voxc

int main() {
  using namespace voxc;
  demandEach<Descent>("traversal");
  demandEach<Precision>("step");
  demandEach<Addressing>("memory");
  demandEach<RayStage>("header");
  for (std::size_t i = 0; i < kEnumNames<Payload>.size(); ++i) {
    const PayloadKind &kind = kindOf(static_cast<Payload>(i));
    demand("shaders-runtime", shaderFiles(), "payload/" + std::string(kind.hit) + ".glsl");
    if (!kind.blocks.empty())
      demand("shaders-runtime", shaderFiles(), "values/" + std::string(kind.blocks) + ".glsl");
  }
  for (const SlotKind *kind : slotKinds())
    for (const bool implied : {false, true}) {
      Stratum stratum;
      stratum.slots = kind;
      stratum.encoding = defaultEncoding(*kind);
      stratum.implied = implied;
      for (const std::string_view file : kind->accessor(stratum))
        demand("shaders-runtime", shaderFiles(), "slots/" + std::string(file) + ".glsl");
      demand(kind->construct);
      demand(kind->writing(stratum));
      demand(kind->edit);
      if (kind->root)
        demand({kTree.header, kind->root(stratum)});
    }
  return problems == 0 ? 0 : 1;
}
