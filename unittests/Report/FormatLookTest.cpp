// Names and families of formats.
#include "report/FormatLook.h"

#include <gtest/gtest.h>

namespace voxc::report {
namespace {

std::string nameOf(const std::string &format) { return lookOf(format).name; }
std::string_view familyOf(const std::string &format) { return families()[lookOf(format).family]; }

TEST(FormatLook, HasOneNameForAllSpellings) {
  EXPECT_EQ(nameOf("R(4^3) G(7)"), "R(4³) G(7)");
  EXPECT_EQ(nameOf("R(4,4,4)G(7)"), "R(4³) G(7)");
  EXPECT_EQ(nameOf("D(4^3, 6) S(7)"), "D(4³, 6) S(7)");
  EXPECT_EQ(nameOf("R(4, 3, 4)"), "R(4, 3, 4)");
}

TEST(FormatLook, TellsFamiliesApart) {
  EXPECT_EQ(familyOf("R(4^3) S(3) G(4)"), "R over a DAG (G)");
  EXPECT_EQ(familyOf("R(4^3) S(7)"), "R over an octree (S)");
  EXPECT_EQ(familyOf("D(4^3, 6) R(3^3) G(4)"), "D over a tree");
  EXPECT_EQ(familyOf("D(6^3, 6) S(5)"), "D over a tree");
  EXPECT_EQ(familyOf("S(5) G(6)"), "trees alone");
  EXPECT_EQ(familyOf("D(5^3, 6) R(4^3)"), "grids alone");
  EXPECT_EQ(familyOf("S(5) R(4^3)"), "others");
}

TEST(FormatLook, KeepsWhatIsNoFormat) {
  EXPECT_EQ(nameOf("<script>"), "<script>");
  EXPECT_EQ(familyOf("<script>"), "others");
  EXPECT_EQ(nameOf(""), "");
}

} // namespace
} // namespace voxc::report
