// Printing a plan as intersect.cpp: the same functions as in intersect.glsl, as members of a class.
#include "FormatWords.h"
#include "KernelConstants.h"
#include "KernelFunctions.h"
#include "Names.h"
#include "RuntimeText.h"

#include "Glsl/Cpp.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <cctype>
#include <set>

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
                             "load_word/1", // Of two overloads; where a volume has pages, it is a member.
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

constexpr std::string_view kHowToCompile =
    "// C++20, for Clang 17 and GCC 12, or later ones: Clang 16 knows no __builtin_roundevenf.\n"
    "// Integers wrap, as in GLSL, nothing is contracted, and floats are read as their bits:\n"
    "//     -O3 -fwrapv -ffp-contract=off -fno-strict-aliasing\n";

constexpr std::string_view kKernelBegin =
    "VOXC_BEGIN_INLINE\n\n// One without the exact fallback defers the rays that need exact arithmetic to "
    "one with it.\n"
    "template <bool EXACT_FALLBACK> struct Kernel : Interface<Plan> {\n";

/// What the plan decides, as far as the headers ask for it.
std::string planText(const Plan &plan, std::string_view header, bool countWords) {
  std::set<std::string, std::less<>> asked;
  for (const EmbeddedFile &file : includedBy({header}, intersectHeaders()))
    asked.merge(namesBehind("Plan::", file.text));
  std::string text;
  if (plan.packetWidth == PacketWidth::Narrow)
    text += "#define VOXC_NARROW_PACKETS // Each level has a loop, and lanes in one wait for those in "
            "another: fewer lanes, less waiting.\n";
  text += "#include \"voxc_interface.h\"\n\nnamespace {\n\nusing namespace voxc::glsl;\n\n// What the plan "
          "decides.\n"
          "struct Plan {\n";
  for (const PlanConstant &constant : planConstants())
    if (asked.contains(constant.name))
      text += "  static constexpr " + constantText(constant.name, constant.of(plan)) + "\n";
  return text + "  static constexpr " + constantText("COUNT_WORDS", countWords) + "\n};\n\n";
}

/// The members of the kernel's class, behind those of its `Interface`.
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
  const auto module = members(KernelBuilder(plan));
  if (!module)
    return "#error " + module.error().message + "\n";
  const std::string rest = plan.isOfPoints() ? "voxc_points.h" : "voxc_batches.h";
  return "// intersect.cpp: " + std::string(answers(plan.query)) + " volumes of the format " +
         plan.layout.format + ".\n" + std::string(kHowToCompile) + planText(plan, rest, countWords) +
         std::string(kKernelBegin) + indented(glsl::Cpp().print(*module)) +
         "};\n\nVOXC_END_INLINE\n\n} // namespace\n\n#define VOXC_SYMBOL " + std::string(symbol) +
         "\n#include \"" + rest + "\"\n";
}

std::string emitDispatchCpp(std::string_view symbol) {
  return replaceWords(runtimeFile(cpuFiles(), "dispatch.cpp"), {{"voxc_kernel", std::string(symbol)}});
}

std::string emitIntersectHeader(const Plan &plan, std::string_view symbol) {
  FormatWords words = formatWords(plan.layout);
  words["voxc_kernel"] = symbol;
  words["VOXC_KERNEL_"] = upperCase(symbol) + "_";
  words["ANSWERS"] = answers(plan.query);
  words["HAS_BOUNDS"] = plan.bounded ? "1" : "0";
  return replaceWords(runtimeFile(cpuFiles(), "intersect.h"), words);
}

} // namespace voxc
