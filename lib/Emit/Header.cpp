// Printing a plan as functions for the shaders and programs of others.
#include "HeaderLanguages.h"
#include "KernelFunctions.h"
#include "Names.h"
#include "RuntimeText.h"

#include "Glsl/Passes.h"
#include "Glsl/Wrap.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <cctype>
#include <span>

namespace voxc {
namespace {

/// The text of a C++ header to be pasted into another: without what ties it to its file.
std::string pasted(std::string_view header) {
  std::string text;
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find('\n', begin), header.size() - 1) + 1;
    const std::string_view line = header.substr(begin, end - begin);
    if (!line.starts_with("#pragma once") && !line.starts_with("#include \""))
      text += line;
    begin = end;
  }
  return text;
}

std::string glslInCpp() {
  return "\n" + pasted(runtimeFile(intersectHeaders(), "voxc_vector.h")) + "\n" +
         pasted(runtimeFile(intersectHeaders(), "voxc_glsl.h"));
}

std::string upperCase(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
  return result;
}

FormatWords headerWords(const Plan &plan, std::string_view name) {
  const std::string prefix = headerPrefix(name);
  FormatWords words = formatWords(plan.layout);
  words["voxc_format_"] = prefix;
  words["voxc_format"] = prefix.substr(0, prefix.size() - 1);
  words["VOXC_FORMAT_"] = upperCase(prefix);
  words["GLSL_IN_CPP"] = glslInCpp();
  words["COLOUR_MEANING"] = plan.layout.hasLabels() ? "a label" : "R in the lowest byte, then G, B and A";
  return words;
}

/// Of plans with bounds.
constexpr std::string_view kQueries[] = {"bounds", "header/hit", "header/queries"};
/// Of plans without.
constexpr std::string_view kFirst[] = {"header/hit", "header/first"};

/// What is called from outside.
const glsl::Names kRoots = {"VOLUME_SIZE"};
constexpr std::string_view kCalled[] = {"Hit", "closest", "next", "any", "first", "normal", "outside"};

/// All functions, after those that a language lacks, by names that are a format's own.
Expected<glsl::Module> moduleOf(KernelBuilder builder, const HeaderLanguageKind &language,
                                const std::string &prefix) {
  addVolumeSize(builder);
  for (const std::string_view file : language.lacking)
    builder.add(file);
  builder.add("header/load");
  addKernelFunctions(builder);
  builder.add("continue_traversal");
  for (const std::string_view file :
       builder.plan().bounded ? std::span<const std::string_view>(kQueries) : kFirst)
    builder.add(file);
  glsl::Names roots = kRoots;
  if (builder.plan().addressing == Addressing::Paged)
    roots.insert("lacks_page");
  for (const std::string_view name : kCalled)
    roots.insert(prefix + std::string(name));
  auto module = VOXC_TRY(std::move(builder).specialised(roots));
  glsl::addParameter(module, "load_word", {glsl::Passing::In, std::string(language.volume), "volume"});
  glsl::addPrefix(module, prefix);
  if (language.makeReady)
    language.makeReady(module);
  return module;
}

} // namespace

bool isHeaderName(std::string_view name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !name.empty() && std::ranges::all_of(name, fits) && !name.starts_with('_') && !name.ends_with('_') &&
         name.find("__") == std::string_view::npos;
}

std::string headerName(const Layout &layout) {
  std::string name;
  for (const char c : layout.format) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c != '(' && !name.empty() && name.back() != '_')
      name += '_';
  }
  name.resize(name.find_last_not_of('_') + 1);
  return name;
}

std::string headerPrefix(std::string_view name) { return "voxc_" + std::string(name) + "_"; }

std::string headerFile(std::string_view name, HeaderLanguage language) {
  return "voxc_" + std::string(name) + std::string(kindOf(language).extension);
}

std::string emitHeader(const Plan &plan, std::string_view name, HeaderLanguage language) {
  const HeaderLanguageKind &kind = kindOf(language);
  const FormatWords words = headerWords(plan, name);
  KernelBuilder builder(plan, words);
  builder.define("COUNT_LOOKUPS", "false");
  builder.define("EXACT_FALLBACK", "true"); // Exact arithmetic is at hand.
  // Rays that begin far away are moved near the volume, by sums that are rounded once and not put in another
  // order. Where nothing keeps a compiler from doing so, such rays are resolved instead.
  builder.define("COMES_NEAR", kind.keepsSums ? "true" : "false");
  const auto module = moduleOf(std::move(builder), kind, headerPrefix(name));
  if (!module)
    return "#error " + module.error().message + "\n";
  std::string text;
  for (const std::string &file : kind.filesBefore(plan))
    text += replaceWords(runtimeFile(shaderFiles(), file), words);
  return glsl::wrapped(text) + "\n" + kind.printer(headerPrefix(name))->print(*module) +
         replaceWords(runtimeFile(shaderFiles(), kind.end), words);
}

std::string emitCHeader(const Plan &plan, std::string_view name) {
  return replaceWords(runtimeFile(cpuFiles(), "functions.h"), headerWords(plan, name));
}

std::string emitCDefinitions(const Plan &plan, std::string_view name) {
  return replaceWords(runtimeFile(cpuFiles(), "functions.cpp"), headerWords(plan, name));
}

std::string_view carryFunctions() { return runtimeFile(shaderFiles(), "builtins/carries.glsl"); }

std::string emitRayShader(const Plan &plan, std::string_view name, RayStage stage) {
  return replaceWords(runtimeFile(shaderFiles(), "header/" + std::string(toString(stage)) + ".glsl"),
                      headerWords(plan, name));
}

} // namespace voxc
