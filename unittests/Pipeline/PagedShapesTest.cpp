// Shapes and normals from pages: those of the whole volume, and no voxel's value is read for them.
#include "PagingTesting.h"
#include "TestLength.h"

#include "testing/RandomFormat.h"
#include "voxc/Render/SurfaceNormals.h"

#include <gtest/gtest.h>

#include <fstream>

namespace voxc {
namespace {

using namespace test;

constexpr std::uint64_t kNoRoom = 0;
constexpr std::uint64_t kSomeRoom = 4 * kSmallPage;
constexpr std::uint64_t kPlenty = std::uint64_t{1} << 30;

/// Every voxel of the format, and some beside it.
void expectSameShape(const Volume &volume, const PagedVolume &pages, std::uint64_t shelfBytes) {
  const std::string what = printIr(volume.format());
  const ShapeReader whole(volume);
  const ShapeReader paged(pages, std::make_shared<PageShelf>(shelfBytes));
  const Int3 extent = volume.format().extent();
  for (int z = -1; z <= extent.z; ++z)
    for (int y = -1; y <= extent.y; ++y)
      for (int x = -1; x <= extent.x; ++x) {
        const ShapeCube cube = paged.at({x, y, z});
        ASSERT_EQ(cube.isFull, volume.lookup({x, y, z}).value != 0) << what << x << ' ' << y << ' ' << z;
        ASSERT_EQ(cube.log2Side, whole.at({x, y, z}).log2Side) << what << x << ' ' << y << ' ' << z;
      }
  EXPECT_FALSE(paged.problem()) << what;
}

TEST_F(Paging, TellsTheShapesOfVolumesOfEveryKind) {
  std::size_t number = 0;
  for (const char *text : kFormats) {
    const Format format = *parseFormat(text);
    const auto volume = build(format, sceneOf(format, number++));
    ASSERT_TRUE(volume) << volume.error().message;
    expectSameShape(*volume, paged(*volume), kSomeRoom);
  }
}

TEST_F(Paging, TellsTheShapesOfVolumesInRandomFormats) {
  std::mt19937 random(43);
  for (int i = 0; i < rounds(12); ++i) {
    const Format format = randomFormat(random, pick(random, 3, 5));
    const auto volume = build(format, noise(format.extent(), i));
    ASSERT_TRUE(volume) << volume.error().message;
    expectSameShape(*volume, paged(*volume), i % 2 == 0 ? kNoRoom : kSomeRoom);
  }
}

std::vector<Hit> allVoxels(const Volume &volume) {
  std::vector<Hit> hits;
  EXPECT_TRUE(decode(volume, [&](const Cube &cube, std::uint32_t) {
    for (std::uint64_t code = 0; code < std::uint64_t{1} << 3 * cube.log2Side; ++code) {
      const Int3 voxel = cube.low + mortonCell(code);
      hits.push_back({{voxel.x, voxel.y, voxel.z}});
    }
    return true;
  }));
  return hits;
}

/// A slope with stones on it: normals in all directions, and voxels without any.
HardScene slope(Int3 extent) {
  const auto voxel = [](Int3 c) {
    const bool isGround = 2 * c.y < c.x + c.z && 2 * c.y > c.x + c.z - 6;
    const bool isStone = c.x % 17 < 3 && c.y % 13 < 3 && c.z % 11 < 3;
    return isGround || isStone ? 0xff000000u | static_cast<std::uint32_t>(c.x * 7919 + c.z) : 0u;
  };
  return {"slope", voxel, {}, extent};
}

/// A volume that has pages of shapes and pages of values.
class PagedNormals : public Paging {
protected:
  void SetUp() override {
    Paging::SetUp();
    auto built = build(format_, slope(format_.extent()));
    ASSERT_TRUE(built) << built.error().message;
    volume_.emplace(std::move(*built));
    pages_.emplace(paged(*volume_));
    hits_ = allVoxels(*volume_);
    ASSERT_GT(hits_.size(), 5000);
  }

  void expectSame(const SurfaceNormals &normals) {
    SurfaceNormals whole(*volume_, 2);
    ASSERT_TRUE(whole.learn(hits_));
    std::size_t directions = 0;
    for (const Hit &hit : hits_) {
      const SurfaceNormal expected = whole.at(hit), normal = normals.at(hit);
      ASSERT_EQ(normal.direction, expected.direction);
      ASSERT_EQ(normal.roomAlong, expected.roomAlong);
      ASSERT_EQ(normal.roomAgainst, expected.roomAgainst);
      directions += normal.direction != glm::vec3(0);
    }
    EXPECT_GT(directions, hits_.size() / 2);
  }

  const Format format_ = *parseFormat("format values=apart { level 1: raw(2, 2, 2) level 2: svdag(4) }");
  std::optional<Volume> volume_;
  std::optional<PagedVolume> pages_;
  std::vector<Hit> hits_;
};

TEST_F(PagedNormals, AreThoseOfTheWholeVolume) {
  for (const std::uint64_t room : {kNoRoom, kSomeRoom, kPlenty})
    for (const unsigned threads : {1u, 3u}) {
      SurfaceNormals normals(*pages_, std::make_shared<PageShelf>(room), threads);
      ASSERT_TRUE(normals.learn(hits_));
      expectSame(normals);
    }
}

TEST_F(PagedNormals, ReadEachPageOnceAndNoneOfValues) {
  const auto shelf = std::make_shared<PageShelf>(kPlenty);
  SurfaceNormals normals(*pages_, shelf, 1);
  ASSERT_TRUE(normals.learn(hits_));
  EXPECT_GT(normals.pagesRead(), 0);
  EXPECT_EQ(shelf->bytes(), normals.pagesRead() * kSmallPage);
  EXPECT_LT(normals.pagesRead(), pages_->streams().front().pages());
  SurfaceNormals others(*pages_, shelf, 1);
  ASSERT_TRUE(others.learn(hits_));
  EXPECT_EQ(others.pagesRead(), 0);
}

TEST_F(PagedNormals, OfADamagedPageAreAnError) {
  {
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(pages_->headBytes() + 100));
    file.write("wrong", 5);
  }
  auto damaged = PagedVolume::open(path_);
  ASSERT_TRUE(damaged) << damaged.error().message;
  SurfaceNormals normals(*damaged, std::make_shared<PageShelf>(kPlenty), 2);
  const auto learned = normals.learn(hits_);
  ASSERT_FALSE(learned);
  EXPECT_EQ(learned.error().kind, ErrorKind::Input);
  EXPECT_NE(learned.error().message.find("is not what was stored"), std::string::npos);
}

} // namespace
} // namespace voxc
