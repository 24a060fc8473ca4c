// Diagnostics and Morton codes.
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Geometry.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

TEST(Diagnostics, PutCaretsUnderTheWholeRange) {
  Diagnostics diagnostics;
  diagnostics.error({7, 10}, "bad");
  EXPECT_EQ(render(diagnostics, "one\n\ttwo three\n", "name"),
            "name:2:4: error: bad\n  \ttwo three\n  \t  ^^^\n");
}

TEST(Diagnostics, ShowWhatIsAroundTheRangeOfALongLine) {
  Diagnostics diagnostics;
  diagnostics.error({100000, 100003}, "wrong");
  const std::string text = std::string(100000, 'a') + "bad" + std::string(100000, 'b');
  const std::string shown = std::string(200, 'a') + "bad" + std::string(197, 'b');
  EXPECT_EQ(render(diagnostics, text, "name"),
            "name:1:100001: error: wrong\n  " + shown + "\n  " + std::string(200, ' ') + "^^^\n");
}

/// A text of a stranger may be wrong a million times, each time in the same long line.
TEST(Diagnostics, KeepFiftyAndSayThatThereAreMore) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < 1000000; ++i)
    diagnostics.error({i, i + 1}, "wrong");
  ASSERT_EQ(diagnostics.all().size(), 51u);
  EXPECT_EQ(diagnostics.all().back().message, "there are more errors from here on");
  EXPECT_LT(render(diagnostics, std::string(1000000, 'a'), "name").size(), 51u * 1000u);
}

TEST(Diagnostics, ShowTheEnd) {
  Diagnostics diagnostics;
  diagnostics.error({3, 3}, "missing");
  EXPECT_EQ(render(diagnostics, "abc", "name"), "name:1:4: error: missing\n  abc\n     ^\n");
}

TEST(Morton, IsItsOwnInverse) {
  const Int3 cells[] = {{0, 0, 0}, {1, 0, 0},     {0, 1, 0},
                        {0, 0, 1}, {5, 1999, 77}, {0x1fffff, 0x155555, 0x0aaaaa}};
  for (const Int3 cell : cells)
    EXPECT_EQ(mortonCell(mortonCode(cell)), cell);
  EXPECT_EQ(mortonCode({1, 0, 0}), 1u);
  EXPECT_EQ(mortonCode({0, 1, 0}), 2u);
  EXPECT_EQ(mortonCode({0, 0, 1}), 4u);
  EXPECT_EQ(mortonCode({0b011, 0b101, 0b110}), 0b110'101'011u) << "z, y, x of bit 2, then 1, then 0";
}

} // namespace
} // namespace voxc
