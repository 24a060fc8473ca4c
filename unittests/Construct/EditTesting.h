// What tests of edits share.
#pragma once

#include "testing/RandomFormat.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace voxc::test {

inline Format formatWith(const std::string &text, const std::vector<std::string> &passes) {
  Format format = *parseFormat(text);
  EXPECT_TRUE(runPasses(format, passes));
  return format;
}

inline std::shared_ptr<const Volume> buildVolume(const Format &format, VoxelSource &source) {
  const auto constructor = Constructor::compile(format);
  auto built = constructor->build(source);
  return built ? std::make_shared<const Volume>(std::move(built->volume)) : nullptr;
}

inline std::vector<std::uint32_t> wordsOf(const Volume &volume) {
  return {volume.words().begin(), volume.words().end()};
}

/// A cell between 0 and `most`.
inline Int3 within(std::mt19937 &random, Int3 most) {
  return {pick(random, 0, most.x), pick(random, 0, most.y), pick(random, 0, most.z)};
}

} // namespace voxc::test
