// The languages of headers.
#include "Emit/HeaderLanguages.h"

#include "Emit/SharedLanguage.h"

#include "Glsl/Cpp.h"
#include "Glsl/Cuda.h"
#include "Glsl/Hlsl.h"
#include "Glsl/Wgsl.h"

#include <array>

namespace voxc {
namespace {

constexpr std::array<std::string_view, 3> kLackingInGlslEs = {"builtins/bits", "builtins/mix",
                                                              "builtins/carries"};
constexpr std::array<std::string_view, 2> kLackingInHlsl = {"builtins/mix", "builtins/carries"};
constexpr std::array<std::string_view, 1> kLackingInWgsl = {"builtins/carries"};

template <typename Printer> std::unique_ptr<glsl::Printer> make(const std::string &) {
  return std::make_unique<Printer>();
}

std::unique_ptr<glsl::Printer> makeWgsl(const std::string &prefix) {
  return std::make_unique<glsl::Wgsl>(prefix + "word");
}

/// GLSL ES has no `precise`.
class GlslEs : public glsl::Printer {
protected:
  std::string beforeLocal(const std::string &qualifiers) const override {
    return qualifiers == "precise" ? "" : Printer::beforeLocal(qualifiers);
  }
  std::string beforeFunction(const glsl::Declaration &) const override { return ""; }
};

class Glsl : public glsl::Printer {
protected:
  std::string beforeFunction(const glsl::Declaration &) const override { return ""; }
};

/// In the order of `HeaderLanguage`.
constexpr std::string_view kMacro = "VOXC_VOLUME", kPointer = "const unsigned int *";

constexpr std::array<HeaderLanguageKind, 7> kLanguages = {{
    {.extension = ".h",
     .begin = "header/languages/shared.begin",
     .end = "header/languages/shared.end",
     .volume = kMacro,
     .printer = make<SharedLanguage>},
    {.extension = ".glsl",
     .begin = "header/languages/glsl.begin",
     .end = "header/languages/glsl.end",
     .volume = kMacro,
     .printer = make<Glsl>},
    {.extension = ".essl",
     .begin = "header/languages/essl",
     .end = "header/languages/essl.end",
     .volume = kMacro,
     .printer = make<GlslEs>,
     .lacking = kLackingInGlslEs,
     .keepsSums = false,
     .hasForms = true},
    {.extension = ".hpp",
     .begin = "header/languages/cpp.begin",
     .end = "header/languages/cpp.end",
     .volume = kPointer,
     .printer = make<glsl::CppHeader>},
    {.extension = ".cuh",
     .begin = "header/languages/cuda.begin",
     .end = "header/languages/cuda.end",
     .volume = kPointer,
     .printer = make<glsl::Cuda>,
     .makeReady = glsl::forCuda},
    {.extension = ".hlsl",
     .begin = "header/languages/hlsl.begin",
     .end = "header/languages/hlsl.end",
     .volume = kMacro,
     .printer = make<glsl::Hlsl>,
     .makeReady = glsl::forHlsl,
     .lacking = kLackingInHlsl},
    {.extension = ".wgsl",
     .begin = "header/languages/wgsl.begin",
     .end = "header/languages/wgsl.end",
     .volume = "uint",
     .printer = makeWgsl,
     .makeReady = glsl::forWgsl,
     .lacking = kLackingInWgsl,
     .keepsSums = false},
}};

} // namespace

std::vector<std::string> HeaderLanguageKind::filesBefore(const Plan &plan) const {
  const std::string path(begin);
  if (!hasForms)
    return {path};
  return {path + (plan.bounded ? "/bounded.begin" : "/first.begin"),
          path + (plan.addressing == Addressing::Paged ? "/paged.begin" : "/loaded.begin"),
          path + "/all.begin"};
}

const HeaderLanguageKind &kindOf(HeaderLanguage language) {
  return kLanguages[static_cast<std::size_t>(language)];
}

} // namespace voxc
