// What tests of paged tracing share: files of small pages, and tracers of them on all back ends.
#pragma once

#include "GranuleTesting.h"

#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Trace/PagedTracer.h"
#include "voxc/Volume/CoarseBlocks.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace voxc::test {

inline constexpr std::uint32_t kSmallPage = 4096;

class Paging : public testing::Test {
protected:
  void SetUp() override { path_ = testing::TempDir() + "voxc-paging-" + std::to_string(::getpid()) + ".hvx"; }
  void TearDown() override { std::filesystem::remove(path_); }

  PagedVolume paged(const Volume &volume, std::uint32_t pageBytes = kSmallPage) {
    EXPECT_TRUE(volume.save(path_, {.compress = true, .pageBytes = pageBytes}));
    auto opened = PagedVolume::open(path_);
    EXPECT_TRUE(opened);
    return std::move(*opened);
  }

  std::string path_;
};

/// A scene without much that repeats, so that there are many pages.
inline HardScene noise(Int3 extent, int seed) {
  const auto voxel = [seed](Int3 c) {
    auto h = static_cast<std::uint32_t>(seed);
    for (const int coordinate : {c.x, c.y, c.z})
      h = (h ^ static_cast<std::uint32_t>(coordinate)) * 73856093u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h % 16 == 0 ? h | 0xff000000u : 0u;
  };
  return {"noise", voxel, {}, extent};
}

inline std::vector<Hit> residentHits(const Volume &volume, const Format &format,
                                     const std::vector<Ray> &rays) {
  std::vector<Hit> hits(rays.size());
  const auto kernel = compileCpuKernel(format, {.start = CpuStart::Fast});
  EXPECT_TRUE(kernel);
  EXPECT_TRUE((*createCpuTracer(*kernel, volume, 2))->trace(rays, hits));
  return hits;
}

inline std::string differences(const std::vector<Hit> &expected, const std::vector<Hit> &hits) {
  std::size_t different = 0;
  std::string first;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (std::memcmp(&expected[i], &hits[i], sizeof(Hit)) != 0 && different++ == 0)
      for (const Hit &hit : {expected[i], hits[i]})
        first += " (" + std::to_string(hit.voxel[0]) + " " + std::to_string(hit.voxel[1]) + " " +
                 std::to_string(hit.voxel[2]) + " " + std::to_string(hit.rgba) + " " + std::to_string(hit.t) +
                 " " + std::to_string(hit.steps) + ")";
  return different == 0 ? "" : std::to_string(different) + " differ:" + first;
}

using MadeTracer = Expected<std::unique_ptr<PagedTracer>>;

inline CpuKernel cpuKernel(const Format &format) {
  const auto kernel = compileCpuKernel(format, {.addressing = Addressing::Paged, .start = CpuStart::Fast});
  EXPECT_TRUE(kernel) << (kernel ? std::string() : kernel.error().message + printIr(format));
  return *kernel;
}

inline MadeTracer onVulkan(Device &device, const PagedVolume &paged, const Format &format,
                           const PagingOptions &options) {
  const auto kernel = compileKernel(format, {.addressing = Addressing::Paged,
                                             .loops = device.info().loops,
                                             .arithmetic = device.info().arithmetic});
  if (!kernel)
    return kernel.error();
  return createPagedTracer(device, *kernel, paged, options);
}

inline MadeTracer onVulkan(Device &device, const PagedVolume &paged, const Format &format,
                           std::uint64_t bytes, bool coarse = false) {
  return onVulkan(device, paged, format, PagingOptions{bytes, 2, coarse});
}

} // namespace voxc::test
