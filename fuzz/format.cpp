// Fuzzes formats and pipelines of passes: names of passes up to a line feed, then a format's text or IR. What
// is valid must come back from its own text, lower to a plan, and that from its text too.
#include "FuzzedFile.h"

#include "voxc/Passes/Pass.h"
#include "voxc/Plan/Plan.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace {

using namespace voxc;

std::vector<std::string> wordsOf(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t end = 0; !line.empty(); line.remove_prefix(std::min(end + 1, line.size()))) {
    end = std::min(line.find(' '), line.size());
    words.emplace_back(line.substr(0, end));
  }
  return words;
}

void expect(bool holds) {
  if (!holds)
    std::abort();
}

void expectPlans(const Format &format) {
  for (const PlanOptions &options : {PlanOptions(), kCpuPlan}) {
    const auto plan = makePlan(format, options);
    expect(static_cast<bool>(plan));
    Diagnostics diagnostics;
    const std::string text = printPlan(*plan);
    const Plan again = parsePlan(text, diagnostics);
    expect(!diagnostics.hasErrors() && again == *plan && printPlan(again) == text);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string_view text = fuzz::textOf(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  auto format = parseFormat(text.substr(std::min(end + 1, text.size())), "format");
  if (!format || !runPasses(*format, wordsOf(text.substr(0, end))))
    return 0;
  const std::string ir = printIr(*format);
  Diagnostics diagnostics;
  const Format again = parseIr(ir, diagnostics);
  expect(!diagnostics.hasErrors() && again == *format && printIr(again) == ir);
  expectPlans(*format);
  return 0;
}
