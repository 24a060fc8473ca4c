// What tests of edits share.
#pragma once

#include "testing/RandomFormat.h"

#include "voxc/Construct/Constructor.h"

#include <memory>
#include <random>
#include <utility>

namespace voxc::test {

inline std::shared_ptr<const Volume> buildVolume(const Format &format, VoxelSource &source) {
  const auto constructor = Constructor::compile(format);
  auto built = constructor->build(source);
  return built ? std::make_shared<const Volume>(std::move(built->volume)) : nullptr;
}

/// A cell between 0 and `most`.
inline Int3 within(std::mt19937 &random, Int3 most) {
  return {pick(random, 0, most.x), pick(random, 0, most.y), pick(random, 0, most.z)};
}

} // namespace voxc::test
