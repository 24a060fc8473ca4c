// The shapes of levels, and the rewrites that lead from composition to composition.
#include "voxc/Search/Composition.h"

#include <algorithm>

namespace voxc {
namespace {

/// Grids of 2^27 cells take half a gigabyte. Distances of octants have four bits each.
constexpr LevelShape kShapes[] = {
    {.letter = 'R', .most = 9},
    {.letter = 'D', .reach = 15, .least = 2, .most = 9},
    {.letter = 'M', .most = 6},
    {.letter = 'H', .least = 3, .most = 9},
    {.letter = 'G'},
    {.letter = 'G', .branching = 2, .least = 2},
    {.letter = 'S'},
};

constexpr std::string_view kTraversals[] = {"", "direct-traversal", "flat-traversal", "restart-sv"};

/// Another traversal is another kernel, whatever its levels are.
constexpr int kHeightsOfTraversal = 6;

/// Collects compositions; those that cannot be are left out.
class Rewriter {
public:
  Rewriter(const Composition &from, std::size_t maxLevels) : from_(from), maxLevels_(maxLevels) {}

  std::vector<Composition> run() {
    for (std::size_t i = 0; i < from_.levels.size(); ++i) {
      reshape(i);
      split(i);
      if (i + 1 < from_.levels.size()) {
        merge(i);
        shift(i);
      }
    }
    choose();
    return std::move(found_);
  }

private:
  /// `count` levels from the one at `index` on give way to others.
  void replace(std::size_t index, std::size_t count, std::initializer_list<ShapedLevel> levels) {
    const auto fits = [](const ShapedLevel &level) { return kShapes[level.shape].takes(level.side); };
    if (!std::ranges::all_of(levels, fits) || from_.levels.size() - count + levels.size() > maxLevels_)
      return;
    Composition to = from_;
    const auto begin = to.levels.begin() + static_cast<std::ptrdiff_t>(index);
    to.levels.insert(to.levels.erase(begin, begin + static_cast<std::ptrdiff_t>(count)), levels);
    found_.push_back(std::move(to));
  }

  void reshape(std::size_t index) {
    const ShapedLevel &level = from_.levels[index];
    for (std::size_t shape = 0; shape < std::size(kShapes); ++shape)
      if (shape != level.shape)
        replace(index, 1, {{shape, level.side}});
  }

  void split(std::size_t index) {
    const ShapedLevel &level = from_.levels[index];
    for (int upper = 1; upper < level.side; ++upper)
      for (std::size_t shape = 0; shape < std::size(kShapes); ++shape) {
        replace(index, 1, {{shape, upper}, {level.shape, level.side - upper}});
        if (shape != level.shape)
          replace(index, 1, {{level.shape, upper}, {shape, level.side - upper}});
      }
  }

  void merge(std::size_t index) {
    const ShapedLevel &upper = from_.levels[index], &lower = from_.levels[index + 1];
    replace(index, 2, {{upper.shape, upper.side + lower.side}});
    if (lower.shape != upper.shape)
      replace(index, 2, {{lower.shape, upper.side + lower.side}});
  }

  void shift(std::size_t index) {
    const ShapedLevel &upper = from_.levels[index], &lower = from_.levels[index + 1];
    const auto heights =
        static_cast<int>(std::max(kShapes[upper.shape].branching, kShapes[lower.shape].branching));
    for (const int more : {-heights, heights})
      replace(index, 2, {{upper.shape, upper.side + more}, {lower.shape, lower.side - more}});
  }

  void choose() {
    Composition to = from_;
    for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered, SmallGrids::ByOctants})
      if (grids != from_.choices.grids) {
        to.choices.grids = grids;
        found_.push_back(to);
      }
    to = from_;
    for (const std::string_view traversal : kTraversals)
      if (traversal != from_.choices.traversal) {
        to.choices.traversal = traversal;
        found_.push_back(to);
      }
  }

  const Composition &from_;
  std::size_t maxLevels_;
  std::vector<Composition> found_;
};

/// The shape of the level at each height from the top down, and where levels begin.
struct Heights {
  std::vector<std::size_t> shapes;
  std::vector<bool> begins;

  explicit Heights(const Composition &composition) {
    for (const ShapedLevel &level : composition.levels)
      for (int height = 0; height < level.side; ++height) {
        shapes.push_back(level.shape);
        begins.push_back(height == 0);
      }
  }
};

} // namespace

std::span<const LevelShape> levelShapes() { return kShapes; }

std::span<const std::string_view> searchedTraversals() { return kTraversals; }

std::string toString(const Composition &composition) {
  std::string text;
  for (const ShapedLevel &level : composition.levels) {
    const LevelShape &shape = kShapes[level.shape];
    const bool isTree = findLevelKind(shape.letter)->isTree();
    text += (text.empty() ? "" : " ") + std::string(1, shape.letter) + "(" + std::to_string(level.side) +
            (isTree ? "" : "^3") + (shape.reach > 0 ? ", " + std::to_string(shape.reach) : "") +
            (shape.branching > 1 ? ", " + std::to_string(shape.branching) : "") + ")";
  }
  return text;
}

std::optional<Composition> compositionOf(const Format &format) {
  Composition composition;
  for (const Level &level : format.levels) {
    const int side = maxComponent(level.log2Size());
    const std::uint32_t branching = std::max(level.parameter(ParameterRole::Branching), 1u);
    const auto shape = std::ranges::find_if(kShapes, [&](const LevelShape &known) {
      return known.letter == level.kind->letter && known.reach == level.parameter(ParameterRole::Reach) &&
             known.branching == branching && known.takes(side);
    });
    if (shape == std::end(kShapes) || !level.isCubic())
      return std::nullopt;
    composition.levels.push_back({static_cast<std::size_t>(shape - std::begin(kShapes)), side});
  }
  return composition;
}

std::vector<Composition> rewritesOf(const Composition &composition, std::size_t maxLevels) {
  return Rewriter(composition, maxLevels).run();
}

int differences(const Composition &a, const Composition &b) {
  const Heights first(a), second(b);
  int count = (a.choices.grids != b.choices.grids ? 1 : 0) +
              (a.choices.traversal != b.choices.traversal ? kHeightsOfTraversal : 0);
  for (std::size_t i = 0; i < std::min(first.shapes.size(), second.shapes.size()); ++i)
    count += (first.shapes[i] != second.shapes[i]) + (first.begins[i] != second.begins[i]);
  return count;
}

} // namespace voxc
