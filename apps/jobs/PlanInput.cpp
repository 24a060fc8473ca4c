// The options that a plan keeps, and the boxes around some of its cubes.
#include "jobs/PlanInput.h"

#include "options/InputArguments.h"

#include <array>
#include <string>
#include <vector>

namespace voxc::tool {

using namespace cluster;

namespace {

/// The cubes of the items, the largest aligned ones that make them up, as far as they lie in the input.
std::vector<std::array<Int3, 2>> boxesOf(const BuildPlan &plan, std::span<const WorkItem> items) {
  std::vector<std::array<Int3, 2>> boxes;
  const int log2Side = plan.cubes.log2Side;
  for (const WorkItem &item : items) {
    const FragmentShare share = plan.shareOf(item);
    for (std::uint64_t at = share.begin; at < share.end;) {
      int log2Cubes = 0;
      while (at % (std::uint64_t{8} << 3 * log2Cubes) == 0 &&
             at + (std::uint64_t{8} << 3 * log2Cubes) <= share.end)
        ++log2Cubes;
      const Int3 low = mortonCell(at) * (1 << log2Side);
      const int side = 1 << (log2Cubes + log2Side);
      if (contains(plan.extent, low))
        boxes.push_back({low, low + Int3{side, side, side}});
      at += std::uint64_t{1} << 3 * log2Cubes;
    }
  }
  // None would be all.
  if (boxes.empty())
    boxes.push_back({Int3{}, Int3{}});
  return boxes;
}

/// An option as a word of a provenance.
std::string encoded(const std::string &option) {
  std::string word;
  for (const char c : option)
    word += c == ' ' ? "%20" : c == '%' ? "%25" : std::string(1, c);
  return word;
}

} // namespace

Expected<Input> openPlanned(const BuildPlan &plan, std::span<const WorkItem> items,
                            const BuildOptions &options) {
  VOXC_TRY(checkInput(plan));
  std::string words;
  for (const std::string &option : plan.options)
    words += (words.empty() ? "" : " ") + encoded(option);
  InputArguments arguments;
  fillFromProvenance(arguments, words);
  InputOptions inputOptions = makeInputOptions(arguments, plan.format.extent());
  inputOptions.progress = options.progress;
  inputOptions.memory = options.memory;
  inputOptions.threads = options.threads;
  if (!inputOptions.crop && inputOptions.interior == Interior::Keep &&
      inputOptions.coverage != Coverage::Centre)
    inputOptions.regions = boxesOf(plan, items);
  auto input = VOXC_TRY(openInput(plan.input, inputOptions));
  const PartNumbers cubes = partNumbersOf(*input.source, plan.format);
  if (input.source->extent() != plan.extent || cubes.log2Side != plan.cubes.log2Side ||
      cubes.count != plan.cubes.count)
    return Error::input("the input has other voxels than when the plan was made; make the plan again");
  return input;
}

} // namespace voxc::tool
