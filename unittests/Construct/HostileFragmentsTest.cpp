// Whatever fragments are merged, a volume comes out that is whole, or an error.
#include "TestLength.h"

#include "Volume/Checksum.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

namespace voxc {
namespace {

constexpr std::size_t kHeaderBytes = 200;
constexpr std::size_t kChecksumAt = 16;

class HostileFragments : public ::testing::Test {
protected:
  HostileFragments() : folder_(std::filesystem::path(::testing::TempDir()) / "voxc-hostile-fragments") {
    std::filesystem::create_directories(folder_);
  }
  ~HostileFragments() override { std::filesystem::remove_all(folder_); }

  std::string path(const char *name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

void putChecksumRight(std::string &bytes) {
  std::memset(bytes.data() + kChecksumAt, 0, sizeof(std::uint64_t));
  Checksum checksum;
  checksum.add(bytes.data() + kHeaderBytes, bytes.size() - kHeaderBytes);
  checksum.add(bytes.data(), kHeaderBytes);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + kChecksumAt, &digest, sizeof digest);
}

/// Changes a bit, or a word to what stands elsewhere, behind the header.
std::string mutated(std::string bytes, std::mt19937 &random) {
  const std::size_t words = (bytes.size() - kHeaderBytes) / 4;
  std::uint32_t from = 0;
  const std::size_t at = kHeaderBytes + random() % words * 4;
  std::memcpy(&from, bytes.data() + (random() % 2 == 0 ? at : kHeaderBytes + random() % words * 4), 4);
  from ^= random() % 3 == 0 ? 0 : 1u << random() % 32;
  std::memcpy(bytes.data() + at, &from, 4);
  putChecksumRight(bytes);
  return bytes;
}

TEST_F(HostileFragments, GiveAWholeVolumeOrNone) {
  std::mt19937 random(19);
  int merged = 0;
  int refused = 0;
  for (int i = 0; i < test::rounds(12); ++i) {
    const Format format = test::randomFormat(random, 4);
    const auto scenes = test::hardScenes(format.extent());
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor) << constructor.error().message;
    const auto source = scenes[random() % scenes.size()].source();
    ASSERT_TRUE(constructor->buildFragment(*source, 0, 1, path("sound.hvf")));
    const std::string sound = *readTextFile(path("sound.hvf"));
    for (int mutation = 0; mutation < 100; ++mutation) {
      std::filesystem::remove(path("whole.hvx"));
      ASSERT_TRUE(writeFile(path("broken.hvf"), mutated(sound, random)));
      const auto built = constructor->merge({path("broken.hvf")}, {.path = path("whole.hvx")});
      EXPECT_EQ(std::filesystem::exists(path("whole.hvx")), static_cast<bool>(built));
      if (!built) {
        ++refused;
        continue;
      }
      ++merged;
      const auto loaded = Volume::load(path("whole.hvx"));
      ASSERT_TRUE(loaded) << loaded.error().message << "\n" << printIr(format);
    }
  }
  EXPECT_GT(merged, 50);
  EXPECT_GT(refused, 100);
}

} // namespace
} // namespace voxc
