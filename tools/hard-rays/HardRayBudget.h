// How the rays of a scene are shared out over the classes of hard rays: a table of weights.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// A class and its rays of a set.
struct ClassShare {
  std::string_view name;
  std::size_t rays;
};

class HardRayBudget {
public:
  /// Reads lines "CLASS SCENE WEIGHT"; * stands for every class or scene, and the last line that fits a class
  /// and a scene counts. # starts a comment. Errors name `name` and the line: an unknown class, no number, no
  /// weight at all.
  static Expected<HardRayBudget> parse(std::string_view text, const std::string &name);
  /// The table that is built in: test/hard-rays/budget.txt.
  static Expected<HardRayBudget> builtin();

  /// `total` rays by weight, in the order of the classes, those without a weight left out.
  std::vector<ClassShare> share(std::string_view scene, std::size_t total) const;

private:
  struct Line {
    std::string className;
    std::string scene;
    unsigned weight;
  };
  unsigned weight(std::string_view className, std::string_view scene) const;

  std::vector<Line> lines_;
};

} // namespace voxc::tool
