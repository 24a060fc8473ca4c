// Printing a plan as intersect.cpp: the same functions as in intersect.glsl, as members of a class.
#include "KernelFunctions.h"
#include "Names.h"

#include "Glsl/Cpp.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace voxc {
namespace {

/// What stands behind the kernel: how many rays, or points, are put to work.
constexpr std::array kRayFiles = {"work.inc", "packet.inc", "exact.inc", "batch.inc", "entry.inc"};
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

std::string upperCase(std::string_view name) {
  std::string result(name);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
  return result;
}

/// What the files of cpu-runtime call, and the members that they look at: always, of rays with bounds, and of
/// rays whose arrival is asked for.
const glsl::Names kCalled = {"RETRY",
                             "NO_PENDING_STEP",
                             "VOLUME_SIZE",
                             "answer",
                             "begin_traversal",
                             "colour_of",
                             "end_traversal",
                             "goes_on",
                             "intersect_level_1",
                             "is_in_volume",
                             "deferred_traversal",
                             "load_direction",
                             "load_origin",
                             "narrow",
                             "resolve_cell",
                             "resolve_step",
                             "exact_step",
                             "step_over_voxel",
                             "store",
                             "store_hit",
                             "traversal_at",
                             "continue_traversal",
                             "words_without_arrival",
                             "words_of_deferred",
                             ".cell",
                             ".cell_margin",
                             ".direction",
                             ".falls",
                             ".inverse",
                             ".late",
                             ".origin_low",
                             ".open",
                             ".origin",
                             ".t_error",
                             ".voxel"};
const glsl::Names kCalledOfBounds = {"bound_traversal", "bounds_of",       "place_of_entry",
                                     "skip_to",         "traverse_within", ".tmin"};
const glsl::Names kCalledOfArrivals = {"arrival_at",   "entered_face", "first_axis",
                                       "time_exactly", "words_of",     ".axis"};

glsl::Names calledFromPackets(const Plan &plan) {
  glsl::Names names = kCalled;
  if (plan.bounded)
    names.insert(kCalledOfBounds.begin(), kCalledOfBounds.end());
  if (plan.outputs.t || plan.outputs.face)
    names.insert(kCalledOfArrivals.begin(), kCalledOfArrivals.end());
  return names;
}

/// The members of the kernel's class, behind those of interface.inc.
Expected<glsl::Module> members(KernelBuilder builder) {
  const Plan &plan = builder.plan();
  addVolumeSize(builder);
  if (plan.addressing == Addressing::Paged)
    builder.add("paging");
  addKernelFunctions(builder);
  if (!plan.isOfPoints()) {
    builder.add("continue_traversal");
    builder.add("bounds");
  }
  builder.add("records/packets");
  builder.add(plan.isOfPoints() ? "point/answer" : "buffers");
  return std::move(builder).specialised(calledFromPackets(plan));
}

} // namespace

std::string emitIntersectCpp(const Plan &plan, std::string_view symbol, bool countWords) {
  TemplateNames names = planNames(plan);
  names.holes["symbol"] = symbol;
  names.holes["count-words"] = countWords ? "true" : "false";
  const auto module = members(KernelBuilder(plan));
  if (!module)
    return "#error " + module.error().message + "\n";
  std::string text =
      fillFile(cpuFiles(), "begin.inc", names) +
      indented(fillFile(cpuFiles(), "interface.inc", names) + "\n" + glsl::Cpp().print(*module));
  for (const char *path : plan.isOfPoints() ? std::span<const char *const>(kPointFiles) : kRayFiles)
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
