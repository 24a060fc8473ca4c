// What tests of kernels build.
#pragma once

#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"

#include <gtest/gtest.h>

#include <utility>

namespace voxc::test {

inline Volume builtScene(const Format &format, const HardScene &scene) {
  const auto constructor = Constructor::compile(format);
  EXPECT_TRUE(constructor) << constructor.error().message;
  auto built = constructor->build(*scene.source());
  EXPECT_TRUE(built) << built.error().message;
  return std::move(built->volume);
}

} // namespace voxc::test
