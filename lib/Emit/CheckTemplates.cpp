// voxc-check-templates: run when voxc is built. Fills every runtime file with the names of a plan, and
// demands a file for each row of each table that names one, so that a misspelt hole, condition or file name
// ends the build.
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

/// Names that emitters add to those of the plan.
TemplateNames allNames() {
  TemplateNames names = planNames(*makePlan(*parseFormat("R(1,1,1) G(1)")));
  for (const char *hole : {"symbol", "PREFIX", "count-words", "prefix", "prefix-", "what-colour-is"})
    names.holes[hole] = "";
  return names;
}

/// Names are checked in branches that do not apply too.
void check(const std::string &folder, std::span<const EmbeddedFile> files) {
  const TemplateNames names = allNames();
  for (const EmbeddedFile &file : files)
    if (const auto filled = fillTemplate(file.text, names); !filled)
      report(folder + "/" + std::string(file.path), filled.error().message);
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
  check("cpu-runtime", cpuFiles());
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
