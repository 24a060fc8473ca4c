// Reading the table of weights, and sharing out by it.
#include "hard-rays/HardRayBudget.h"

#include "testing/HardRays.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace voxc {

/// The files of test/hard-rays that are built in.
std::span<const EmbeddedFile> hardRayFiles();

} // namespace voxc

namespace voxc::tool {

namespace {

constexpr std::string_view kAny = "*";
constexpr unsigned kMostWeight = 1000000;

bool fits(std::string_view pattern, std::string_view name) { return pattern == kAny || pattern == name; }

bool isClass(std::string_view name) {
  return fits(name, kAny) || std::ranges::find(test::hardRayClasses(), name, &test::HardRayClass::name) !=
                                 test::hardRayClasses().end();
}

} // namespace

Expected<HardRayBudget> HardRayBudget::parse(std::string_view text, const std::string &name) {
  HardRayBudget budget;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    Line entry;
    if (!(words >> entry.className))
      continue;
    std::string surplus;
    const std::string where = name + ", line " + std::to_string(number) + ": ";
    if (!isClass(entry.className))
      return Error::input(where + "there is no class '" + entry.className +
                          "' of hard rays; * stands for every class");
    if (!(words >> entry.scene >> entry.weight) || entry.weight > kMostWeight || words >> surplus)
      return Error::input(where + "a line is CLASS SCENE WEIGHT, and a weight is a number from 0 to " +
                          std::to_string(kMostWeight));
    budget.lines_.push_back(std::move(entry));
  }
  if (std::ranges::all_of(budget.lines_, [](const Line &entry) { return entry.weight == 0; }))
    return Error::input(name + ": no class has a weight above 0");
  return budget;
}

Expected<HardRayBudget> HardRayBudget::builtin() {
  const EmbeddedFile &file = hardRayFiles().front();
  return parse(file.text, "the built-in table");
}

unsigned HardRayBudget::weight(std::string_view className, std::string_view scene) const {
  const auto line = std::find_if(lines_.rbegin(), lines_.rend(), [&](const Line &entry) {
    return fits(entry.className, className) && fits(entry.scene, scene);
  });
  return line == lines_.rend() ? 0 : line->weight;
}

std::vector<ClassShare> HardRayBudget::share(std::string_view scene, std::size_t total) const {
  std::uint64_t sum = 0;
  for (const test::HardRayClass &row : test::hardRayClasses())
    sum += weight(row.name, scene);
  std::vector<ClassShare> shares;
  std::uint64_t passed = 0; // Weights of the classes before.
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    const unsigned own = weight(row.name, scene);
    if (own == 0)
      continue;
    const std::uint64_t begin = total * passed / sum, end = total * (passed + own) / sum;
    shares.push_back({row.name, static_cast<std::size_t>(end - begin)});
    passed += own;
  }
  return shares;
}

} // namespace voxc::tool
