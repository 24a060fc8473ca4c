// Opening fragments: all of a file is looked at, and nothing of it stays in memory.
#include "ResidentMemory.h"

#include "Construct/Fragments/FragmentFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>

namespace voxc {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
constexpr std::uint64_t kFragmentBytes = 48 * kMiB;

class FragmentFile : public testing::Test {
protected:
  FragmentFile() : path_(std::filesystem::path(testing::TempDir()) / "voxc-fragment-file.hvf") {}
  ~FragmentFile() override { std::filesystem::remove(path_); }

  /// One part that is one block of numbers.
  void write() {
    Fragment fragment;
    fragment.cube = {{}, 6};
    fragment.words.resize(kFragmentBytes / sizeof(std::uint32_t));
    std::iota(fragment.words.begin(), fragment.words.end(), 0u);
    fragment.blocks = {{BlockRecord::Append, 1, fragment.words.size() - 1}};
    FragmentInfo info{.volume = {}, .log2Side = 6, .share = {0, 1, 0, 1}};
    info.volume.format = *parseFormat("G(6)");
    info.volume.extent = {64, 64, 64};
    auto writer = FragmentWriter::create(path_, info);
    ASSERT_TRUE(writer) << writer.error().message;
    ASSERT_TRUE(writer->add(fragment));
    ASSERT_TRUE(writer->finish(1));
  }

  std::string path_;
};

TEST_F(FragmentFile, IsOpenedWithoutStayingInMemory) {
  write();
  const std::uint64_t before = test::residentBytes();
  auto reader = FragmentReader::open(path_);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_LT(test::residentBytes(), before + kFragmentBytes / 3 + test::shadowBytes(kFragmentBytes));
  ASSERT_FALSE(reader->next().isEnd() || reader->next().failed());
  const auto part = reader->take();
  ASSERT_TRUE(part) << part.error().message;
  ASSERT_EQ(part->words.size(), kFragmentBytes / sizeof(std::uint32_t));
  EXPECT_EQ(part->words.back(), part->words.size() - 1);
}

TEST_F(FragmentFile, OfWhichAByteIsChangedIsRefused) {
  write();
  {
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(kFragmentBytes));
    file.put('x');
  }
  const auto reader = FragmentReader::open(path_);
  ASSERT_FALSE(reader);
  EXPECT_NE(reader.error().message.find("its checksum does not match"), std::string::npos);
}

} // namespace
} // namespace voxc
