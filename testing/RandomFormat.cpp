// Random levels, formats of them, and passes over those.
#include "testing/RandomFormat.h"

#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace voxc::test {

namespace {

constexpr int kLog2FewCells = 5;

/// One level of 2^side cells an axis; the first may stretch its axes apart where `cubic` is not asked for.
std::string randomLevel(std::mt19937 &random, int side, bool cubic) {
  const auto text = [](int number) { return std::to_string(number); };
  std::string dims = text(side) + "^3";
  if (!cubic)
    dims = text(pick(random, 0, side)) + ", " + text(side) + ", " + text(pick(random, 0, side));
  switch (pick(random, 0, 6)) {
  case 0:
    return "R(" + dims + ")";
  case 1:
    return "D(" + dims + ", " + text(pick(random, 1, 3 * (1 << side))) + ")";
  case 2:
    return "S(" + text(side) + ")";
  case 3:
    return "M(" + dims + ")";
  case 4:
    return "H(" + dims + ")";
  case 5:
    return "G(" + text(side) + (side % 2 == 0 ? ", 2)" : ")");
  default:
    return "G(" + text(side) + ")";
  }
}

/// What these state of the voxels, or leave out of them, is for a scene to say; or they ask much of the
/// levels.
bool isOfScene(const Pass &pass) {
  constexpr std::array<const AttributeKind *, 4> kOfScene = {&kPayloadAttribute, &kAlphaAttribute,
                                                             &kValuesAttribute, &kMirrorAttribute};
  return std::ranges::find(kOfScene, pass.choice.kind) != kOfScene.end();
}

/// A pass that chooses a traversal, or null for the traversal that formats have without one: each as likely.
/// strip-traversal is none of them, as it takes back what the others chose, nor is shared-stack, which goes
/// with each.
const Pass *randomTraversal(std::mt19937 &random) {
  std::vector<const Pass *> traversals{nullptr};
  for (const Pass &pass : passes())
    if (pass.effect == AttributeEffect::Traversal && pass.choice.kind)
      traversals.push_back(&pass);
  return traversals[static_cast<std::size_t>(pick(random, 0, static_cast<int>(traversals.size()) - 1))];
}

} // namespace

int pick(std::mt19937 &random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

std::string randomFormatText(std::mt19937 &random, int log2Side) {
  std::string text;
  int left = log2Side;
  const int levels = pick(random, 1, 5);
  for (int level = 0; level < levels; ++level) {
    const int side = level + 1 == levels ? left : pick(random, 0, left);
    left -= side;
    text += (text.empty() ? "" : " ") + randomLevel(random, side, level > 0 || random() % 4 != 0);
  }
  return text;
}

/// The same with values apart, if its levels can number voxels.
Format withValuesApart(const Format &format) {
  Format apart = format;
  Diagnostics diagnostics;
  findPass("values-apart")->run(apart, diagnostics);
  return apart;
}

Format withRandomPasses(std::mt19937 &random, Format format) {
  const int log2Side = maxComponent(format.log2Extent());
  const auto run = [&](const Pass &pass) {
    Diagnostics diagnostics; // What does not apply leaves the format as it is.
    pass.run(format, diagnostics);
  };
  for (const Pass &pass : passes())
    if (pass.effect == AttributeEffect::Storage && !isOfScene(pass) && random() % 2 != 0)
      run(pass);
  if (random() % 2 != 0)
    format = withValuesApart(format);
  // So few cells have no more colours.
  if (format.attributes.value(kValuesAttribute) == "apart" && log2Side <= kLog2FewCells &&
      random() % 2 != 0) {
    Diagnostics diagnostics;
    findPass("palette")->run(format, diagnostics, 3 * kLog2FewCells);
  }
  run(*findPass("short-pointers"));
  if (random() % 2 != 0)
    run(*findPass("octant-counts"));
  if (random() % 2 != 0)
    run(*findPass("octant-masks"));
  if (const Pass *traversal = randomTraversal(random))
    run(*traversal);
  if (random() % 2 != 0)
    run(*findPass("shared-stack"));
  return format;
}

Format randomFormat(std::mt19937 &random, int log2Side) {
  return withRandomPasses(random, *parseFormat(randomFormatText(random, log2Side)));
}

} // namespace voxc::test
