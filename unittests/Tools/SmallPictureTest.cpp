// Pictures made small, for pages.
#include "common/SmallPicture.h"

#include <gmock/gmock.h>

namespace voxc::tool {
namespace {

TEST(SmallPicture, IsShrunkToMeans) {
  const Picture picture{4, 2, {0xff000000u, 0xff0000ffu, 1, 1, 0xff000000u, 0xff0000ffu, 3, 3}};
  const Picture small = shrunk(picture, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.pixels, (std::vector<std::uint32_t>{0xff000080u, 0xff000002u}));
  EXPECT_EQ(shrunk(picture, 4).pixels, picture.pixels);
}

TEST(SmallPicture, IsAnAddressWithinABound) {
  const Picture picture{32, 16, std::vector<std::uint32_t>(512, 0xff204080u)};
  const std::string address = pictureAddress(picture, 90'000);
  EXPECT_THAT(address, testing::StartsWith("data:image/jpeg;base64,/9j/"));
  EXPECT_EQ((address.size() - std::string("data:image/jpeg;base64,").size()) % 4, 0u);
  EXPECT_EQ(pictureAddress(picture, 100), "");
}

} // namespace
} // namespace voxc::tool
