// Printing a plan as intersect.cpp: the same functions as in intersect.glsl, as members of a class.
#include "KernelFunctions.h"
#include "Names.h"

#include "Glsl/Cpp.h"
#include "Glsl/Parse.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace voxc {
namespace {

/// What stands behind the kernel: how many rays, or points, are put to work.
constexpr std::array kRayFiles = {"work.inc", "packet.inc", "batch.inc", "entry.inc"};
constexpr std::array kPointFiles = {"work.inc", "points.inc", "entry.inc"};

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

std::string inCpp(const std::string &functions) {
  const auto module = glsl::parse(functions);
  return module ? "\n" + glsl::Cpp().print(*module) : "#error " + module.error().message + "\n";
}

std::string upperCase(std::string_view name) {
  std::string result(name);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
  return result;
}

} // namespace

std::string emitIntersectCpp(const Plan &plan, std::string_view symbol, bool countWords) {
  TemplateNames names = planNames(plan);
  names.holes["symbol"] = symbol;
  names.holes["count-words"] = countWords ? "true" : "false";
  const bool isPoint = plan.isOfPoints();
  const auto file = [&](const char *path) { return "\n" + fillFile(shaderFiles(), path, names); };
  const std::string bounds = plan.bounded ? file("walk_on.glsl") + file("bounds.glsl") : "";
  const std::string buffers = file("records.glsl") + file(isPoint ? "point/answer.glsl" : "buffers.glsl");
  const std::string paging = plan.addressing == Addressing::Paged ? file("paging.glsl") : "";
  const std::string members = fillFile(cpuFiles(), "interface.inc", names) +
                              inCpp(volumeSize(plan) + paging + kernelFunctions(plan) + bounds + buffers);
  std::string text = fillFile(cpuFiles(), "begin.inc", names) + indented(members);
  for (const char *path : isPoint ? std::span<const char *const>(kPointFiles) : kRayFiles)
    text += fillFile(cpuFiles(), path, names);
  return text;
}

std::string emitDispatchCpp(std::string_view symbol) {
  TemplateNames names;
  names.holes["symbol"] = symbol;
  return fillFile(cpuFiles(), "dispatch.cpp", names);
}

std::string emitIntersectHeader(const Plan &plan, std::string_view symbol) {
  TemplateNames names = planNames(plan);
  names.holes["symbol"] = symbol;
  names.holes["PREFIX"] = upperCase(symbol);
  return fillFile(cpuFiles(), "intersect.h", names);
}

} // namespace voxc
