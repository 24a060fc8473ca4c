// Printing a plan as intersect.cpp: the same functions as in intersect.glsl, as members of a class.
#include "GlslToCpp.h"
#include "KernelFunctions.h"
#include "RuntimeFile.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace voxc {
namespace {

/// Every line but empty ones moved right by two columns.
std::string indented(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    if (text[begin] != '\n')
      result += "  ";
    result += text.substr(begin, end - begin);
    begin = end;
  }
  return result;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string file(std::string_view path) { return std::string(runtimeFile(cpuFiles(), path)); }

std::string upperCase(std::string_view name) {
  std::string result(name);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
  return result;
}

std::string hexadecimal(std::uint64_t number) {
  char digits[19];
  std::snprintf(digits, sizeof digits, "0x%016llx", static_cast<unsigned long long>(number));
  return digits;
}

} // namespace

std::string emitIntersectCpp(const Plan &plan, std::string_view symbol, bool countWords) {
  const std::string dispatch(runtimeFile(shaderFiles(), "dispatch.glsl"));
  const std::string members =
      replaced(file("interface.cpp"), "THE_COUNT_WORDS", countWords ? "true" : "false") +
      glslToCpp(volumeSize(plan) + kernelFunctions(plan) + "\n" + dispatch);
  return "// intersect.cpp: first hits of rays with volumes of the format " + toString(plan.format) +
         ".\n// C++20, for Clang 17 and GCC 12, or later ones: Clang 16 knows no __builtin_roundevenf.\n"
         "// Integers wrap, as in GLSL, nothing is contracted, and floats are read as their bits:\n"
         "//     -O3 -fwrapv -ffp-contract=off -fno-strict-aliasing\n"
         "#include \"voxc_glsl.h\"\n\nusing namespace voxc::glsl;\n\nnamespace {\n\n"
         "VOXC_BEGIN_INLINE\n\nstruct Kernel {\n" +
         indented(members) + "};\n\nVOXC_END_INLINE\n\n" + replaced(file("entry.cpp"), "THE_SYMBOL", symbol);
}

std::string emitIntersectHeader(const Plan &plan, std::string_view symbol) {
  std::string text = replaced(file("intersect.h"), "THE_PREFIX", upperCase(symbol));
  text = replaced(text, "THE_FORMAT", toString(plan.format));
  text = replaced(text, "THE_DIGEST", hexadecimal(storageDigest(plan.format)));
  return replaced(text, "THE_SYMBOL", symbol);
}

} // namespace voxc
