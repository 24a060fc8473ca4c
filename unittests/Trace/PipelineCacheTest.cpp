// What a driver made of a kernel is given to it again: the right driver, whole, and nobody else's.
#include "TestHost.h"

#include "Trace/Vulkan/PipelineCache.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace voxc {
namespace {

namespace fs = std::filesystem;

/// Lavapipe keeps no pipelines. This is the part of a driver that does, before it.
struct Driver {
  PFN_vkGetInstanceProcAddr loader = nullptr;
  PFN_vkCreatePipelineCache create = nullptr;
  PFN_vkGetPhysicalDeviceProperties describe = nullptr;
  VkPhysicalDeviceProperties properties{}; ///< As they were told last.
  std::uint32_t version = 7;
  std::uint32_t headerVendor = 0;     ///< Put before the vendor of the header: 0 for the right one.
  std::string made = "two pipelines"; ///< What it keeps, after the header; empty: nothing but that.
  std::vector<std::string> given;     ///< What each cache was begun with.
};
Driver driver;

std::string madeData() {
  const VkPhysicalDeviceProperties &device = driver.properties;
  const std::uint32_t words[] = {32, 1, device.vendorID ^ driver.headerVendor, device.deviceID};
  std::string bytes(reinterpret_cast<const char *>(words), sizeof words);
  bytes.append(reinterpret_cast<const char *>(device.pipelineCacheUUID), VK_UUID_SIZE);
  return bytes + driver.made;
}

void describeDevice(VkPhysicalDevice device, VkPhysicalDeviceProperties *properties) {
  driver.describe(device, properties);
  properties->driverVersion = driver.version;
  driver.properties = *properties;
}

VkResult createCache(VkDevice device, const VkPipelineCacheCreateInfo *info,
                     const VkAllocationCallbacks *allocator, VkPipelineCache *cache) {
  driver.given.emplace_back(static_cast<const char *>(info->pInitialData), info->initialDataSize);
  VkPipelineCacheCreateInfo empty = *info;
  empty.initialDataSize = 0;
  return driver.create(device, &empty, allocator, cache);
}

VkResult getData(VkDevice, VkPipelineCache, std::size_t *size, void *data) {
  const std::string bytes = madeData();
  if (data)
    std::memcpy(data, bytes.data(), std::min(*size, bytes.size()));
  *size = bytes.size();
  return VK_SUCCESS;
}

PFN_vkVoidFunction functionOf(VkInstance instance, const char *name) {
  const std::string_view text = name;
  if (text == "vkGetPhysicalDeviceProperties")
    return reinterpret_cast<PFN_vkVoidFunction>(&describeDevice);
  if (text == "vkCreatePipelineCache")
    return reinterpret_cast<PFN_vkVoidFunction>(&createCache);
  if (text == "vkGetPipelineCacheData")
    return reinterpret_cast<PFN_vkVoidFunction>(&getData);
  return driver.loader(instance, name);
}

class PipelineCacheTest : public testing::Test {
protected:
  void SetUp() override {
    host_ = test::Host::open();
    if (!host_)
      GTEST_SKIP() << "there is no Vulkan device";
    driver = {};
    driver.loader = host_->device.getInstanceProcAddr;
    const auto real = [&](const char *name) { return driver.loader(host_->device.instance, name); };
    driver.create = reinterpret_cast<PFN_vkCreatePipelineCache>(real("vkCreatePipelineCache"));
    driver.describe =
        reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(real("vkGetPhysicalDeviceProperties"));
    host_->device.getInstanceProcAddr = functionOf;
    folder_ = fs::path(testing::TempDir()) /
              ("pipelines-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    cache_.emplace(*CompileCache::open(folder_.string()));
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Opens the device, traces a ray, and says what the driver was given; one pipeline cache is made at most.
  std::string start(const char *format = "R(2, 2, 2)", bool countSteps = false) {
    driver.given.clear();
    auto device = adoptDevice(host_->device);
    EXPECT_TRUE(device) << device.error().message;
    device->useCache(&*cache_);
    const Format parsed = *parseFormat(format);
    const auto kernel = compileKernel(parsed);
    EXPECT_TRUE(kernel);
    std::vector<std::uint32_t> words(1 + 64, 0xff0000ff);
    words[0] = 1;
    const Volume volume({.format = parsed, .extent = {4, 4, 4}, .voxels = 64}, std::move(words));
    const auto tracer = createTracer(*device, *kernel, volume);
    EXPECT_TRUE(tracer) << tracer.error().message;
    const Ray ray{{1.5f, 1.5f, -2}, {0, 0, 1}};
    Hit hit{};
    EXPECT_TRUE((*tracer)->trace(std::span(&ray, 1), {&hit, 1}, {.countSteps = countSteps}));
    EXPECT_EQ(hit.t, 2);
    EXPECT_EQ(driver.given.size(), 1u);
    return driver.given.empty() ? "none" : driver.given.front();
  }

  std::unique_ptr<test::Host> host_;
  fs::path folder_;
  std::optional<CompileCache> cache_;
};

TEST_F(PipelineCacheTest, GivesTheDriverWhatItMade) {
  EXPECT_EQ(start(), "");
  EXPECT_EQ(start(), madeData());
  EXPECT_EQ(cache_->usage().entries, 1u);
}

TEST_F(PipelineCacheTest, TellsKernelsAndVariantsApart) {
  EXPECT_EQ(start(), "");
  EXPECT_EQ(start("M(2, 2, 2)"), "");
  EXPECT_EQ(start("R(2, 2, 2)", true), "");
  EXPECT_EQ(cache_->usage().entries, 3u);
}

TEST_F(PipelineCacheTest, TellsVersionsOfTheDriverApart) {
  EXPECT_EQ(start(), "");
  driver.version = 8;
  EXPECT_EQ(start(), "");
  EXPECT_EQ(start(), madeData());
}

TEST_F(PipelineCacheTest, GivesNothingThatIsDamaged) {
  EXPECT_EQ(start(), "");
  const std::string file = fs::directory_iterator(folder_)->path().string();
  std::string bytes = *readTextFile(file);
  bytes.back() ^= 1;
  ASSERT_TRUE(writeFile(file, bytes));
  EXPECT_EQ(start(), "");
  EXPECT_EQ(start(), madeData());
}

TEST_F(PipelineCacheTest, KeepsNeitherOthersDataNorBareHeaders) {
  driver.headerVendor = 1;
  EXPECT_EQ(start(), "");
  driver.headerVendor = 0;
  driver.made = "";
  EXPECT_EQ(start(), "");
  EXPECT_EQ(cache_->usage().entries, 0u);
}

TEST_F(PipelineCacheTest, ServesTracersThatOpenTheirDevice) {
  const Format format = *parseFormat("R(2, 2, 2)");
  const Volume volume({.format = format, .extent = {4, 4, 4}}, std::vector<std::uint32_t>(1 + 64));
  for (const char *device : {"", "cpu"})
    ASSERT_TRUE(openTracer(volume, {.device = device, .cache = &*cache_}));
  const std::uint64_t entries = cache_->usage().entries;
  EXPECT_GE(entries, 2u);
  for (const char *device : {"", "cpu"})
    ASSERT_TRUE(openTracer(volume, {.device = device, .cache = &*cache_}));
  EXPECT_EQ(cache_->usage().entries, entries);
}

TEST(PipelineData, IsThatOfTheDevice) {
  VkPhysicalDeviceProperties device{};
  device.vendorID = 0x10de;
  device.deviceID = 0x2330;
  device.pipelineCacheUUID[3] = 9;
  driver.properties = device;
  driver.headerVendor = 0;
  driver.made = "x";
  const std::string right = madeData();
  EXPECT_TRUE(isPipelineData(right, device));
  EXPECT_FALSE(isPipelineData(std::string_view(right).substr(0, 32), device));
  EXPECT_FALSE(isPipelineData("", device));
  for (std::size_t byte = 0; byte < 32; ++byte) {
    std::string wrong = right;
    wrong[byte] ^= 1;
    EXPECT_FALSE(isPipelineData(wrong, device)) << byte;
  }
}

} // namespace
} // namespace voxc
