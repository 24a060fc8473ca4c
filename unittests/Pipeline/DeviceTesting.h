// What tests of kernels on both back ends share.
#pragma once

#include "voxc/Kernel/OpenTracer.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

namespace voxc::test {

/// The name of a device as a parameter; "cpu" is this processor. Where there is no such device, tests skip.
class OnDevice : public ::testing::TestWithParam<const char *> {
protected:
  void SetUp() override {
    if (std::string(GetParam()) == "cpu")
      return;
    auto device = Device::open(GetParam());
    if (!device)
      GTEST_SKIP() << "there is no such device";
    device_.emplace(std::move(*device));
  }

  Expected<std::unique_ptr<Tracer>> tracerOf(const Volume &volume, const Format &format) {
    TracerChoice choice{.device = "cpu", .threads = 2, .format = format};
    if (device_)
      choice.openDevice = &*device_;
    return openTracer(volume, choice);
  }

  std::optional<Device> device_; ///< None: this processor.
};

inline std::string deviceName(const ::testing::TestParamInfo<const char *> &info) { return info.param; }

inline std::string textOf(const Hit &hit) {
  std::string text;
  for (const int coordinate : hit.voxel)
    text += std::to_string(coordinate) + " ";
  return text + std::to_string(hit.rgba) + " " + std::to_string(hit.t) + " " + std::to_string(hit.steps);
}

} // namespace voxc::test
