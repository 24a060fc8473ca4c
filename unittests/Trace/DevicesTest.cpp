// Devices: listed, chosen, and missing.
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"
#include "voxc/Trace/Tracer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace voxc {
namespace {

using testing::HasSubstr;

/// Sets an environment variable while it lives.
class ScopedVariable {
public:
  ScopedVariable(const char *name, const char *value) : name_(name) {
    if (const char *old = std::getenv(name))
      old_ = old;
    setenv(name, value, 1);
  }
  ~ScopedVariable() {
    if (old_)
      setenv(name_, old_->c_str(), 1);
    else
      unsetenv(name_);
  }

private:
  const char *name_;
  std::optional<std::string> old_;
};

TEST(Devices, WithoutDriversThereAreNone) {
  // The loader reads these for every instance, and none is alive here.
  ScopedVariable files("VK_ICD_FILENAMES", "/nonexistent/driver.json");
  ScopedVariable drivers("VK_DRIVER_FILES", "/nonexistent/driver.json");
  EXPECT_TRUE(listDevices().empty());
  auto device = Device::open();
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().kind, ErrorKind::Environment);
  EXPECT_THAT(device.error().message, HasSubstr("no Vulkan device"));
}

TEST(Devices, SayWhatTheyAre) {
  for (const DeviceInfo &device : listDevices()) {
    EXPECT_FALSE(device.name.empty());
    EXPECT_FALSE(device.kind.empty());
    EXPECT_GT(device.memoryBytes, 0u);
    // The least that Vulkan allows.
    EXPECT_GE(device.maxStorageBufferBytes, std::uint64_t{1} << 27);
  }
}

TEST(Devices, UnknownNameNamesThoseThereAre) {
  auto devices = listDevices();
  if (devices.empty())
    GTEST_SKIP() << "there is no Vulkan device";
  auto device = Device::open("no such device");
  ASSERT_FALSE(device);
  EXPECT_THAT(device.error().message, HasSubstr(devices.front().name));
}

TEST(Devices, AreFoundByPartOfTheirNameInAnyCase) {
  for (const DeviceInfo &info : listDevices()) {
    if (!info.usable)
      continue;
    std::string part = info.name.substr(0, 5);
    for (char &character : part)
      character = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    auto device = Device::open(part);
    EXPECT_TRUE(device) << device.error().message;
  }
}

TEST(Devices, LargeVolumesNeedSegments) {
  auto device = Device::open();
  if (!device)
    GTEST_SKIP() << device.error().message;
  std::uint64_t words = device->info().maxStorageBufferBytes / 16 * 4;
  EXPECT_EQ(device->addressingFor(1), Addressing::Buffer);
  EXPECT_EQ(device->addressingFor(words), Addressing::Buffer);
  EXPECT_EQ(device->addressingFor(words + 1), Addressing::Segments);
}

TEST(Devices, GridsAreReadAsTexelsWhereThatIsFast) {
  auto device = Device::open();
  if (!device)
    GTEST_SKIP() << device.error().message;
  const auto addressingOf = [&](const char *text) {
    const auto source = makeBuiltinSource("terrain", 16);
    return device->addressingFor(Constructor::compile(*parseFormat(text))->build(**source)->volume);
  };
  EXPECT_EQ(addressingOf("R(2^3) M(2^3)"),
            device->info().fastTexels ? Addressing::Texels : Addressing::Buffer);
  EXPECT_EQ(addressingOf("R(2^3) G(2)"), Addressing::Buffer);
}

} // namespace
} // namespace voxc
