// What tests of .hvx files share: a folder that disappears, a small volume, and files whose checksum was put
// right.
#pragma once

#include "NewFolder.h"
#include "Volume/Checksum.h"
#include "Volume/VolumeFile.h"
#include "voxc/Support/File.h"
#include "voxc/Volume/Volume.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <span>
#include <string>

namespace voxc::test {

/// The file as someone would write it who knows how a checksum is made.
inline std::string sealed(std::string bytes) {
  constexpr std::size_t kChecksum = 16;
  constexpr std::size_t kAfter = kChecksum + sizeof(std::uint64_t);
  if (bytes.size() < kAfter)
    return bytes;
  Checksum checksum;
  checksum.add(bytes.data(), kChecksum);
  checksum.add(bytes.data() + kAfter, bytes.size() - kAfter);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + kChecksum, &digest, sizeof digest);
  return bytes;
}

class VolumeFile : public ::testing::Test {
protected:
  void SetUp() override {
    folder_ = newFolder("voxc-volume-file");
    path_ = (folder_ / "volume.hvx").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// One voxel, 9, at (1, 0, 0) of G(1).
  static Volume small() { return Volume(smallInfo(), {2, 9, 0x0202, 1}); }

  static VolumeInfo smallInfo() {
    VolumeInfo info;
    info.format = *parseFormat("G(1)");
    info.extent = {2, 1, 1};
    info.voxels = 1;
    info.provenance = "resolution=2";
    info.voxelToModel[3][0] = -1.5;
    return info;
  }

  /// The bytes of a volume's file.
  std::string saved(const Volume &volume) const {
    EXPECT_TRUE(volume.save(path_));
    return *readTextFile(path_);
  }

  /// As `Volume::load`, but of bytes in memory, which outlive the volume: files are slow to write.
  static Expected<Volume> load(const std::string &bytes, bool trusted = false) {
    return readVolumeFile(std::as_bytes(std::span(bytes)), nullptr, "volume.hvx", {.trusted = trusted});
  }

  static std::string errorOf(const std::string &bytes, bool trusted = false) {
    const auto loaded = load(bytes, trusted);
    return loaded ? "no error" : loaded.error().message;
  }

  std::filesystem::path folder_;
  std::string path_;
};

} // namespace voxc::test
