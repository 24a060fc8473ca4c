// Lists of formats.
#include "common/FormatList.h"

#include "voxc/Support/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace voxc::tool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The list of a file with this text.
Expected<std::vector<FormatLine>> readFile(const std::string &text) {
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + "voxc-list-" + test->name() + ".txt";
  EXPECT_TRUE(writeFile(path, text));
  auto list = readFormatList(path);
  std::filesystem::remove(path);
  return list;
}

TEST(FormatList, hasLabelsBareLinesAndComments) {
  const auto list = readFile("# the paper's\n1\tR(4^3) G(7)\n\nG(3)\r\n  \n x y \t S(2) \t\n#G(9)\nG(4)");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(*list, ElementsAre(FormatLine{"1", "R(4^3) G(7)"}, FormatLine{"", "G(3)"},
                                 FormatLine{"x y", "S(2)"}, FormatLine{"", "G(4)"}));
}

TEST(FormatList, standsOnTheCommandLine) {
  const auto list = readFormatList("G(3);R(2) G(2) ;; a\tS(4)");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(*list,
              ElementsAre(FormatLine{"", "G(3)"}, FormatLine{"", "R(2) G(2)"}, FormatLine{"a", "S(4)"}));
}

TEST(FormatList, keepsFormatsThatAreWrong) {
  const auto list = readFile("bad\tX(3)\nworse\n");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(*list, ElementsAre(FormatLine{"bad", "X(3)"}, FormatLine{"", "worse"}));
}

struct BadList {
  std::string text, message;
};

TEST(FormatList, tellsWhatIsWrongWithAList) {
  const BadList lists[] = {{"# nothing\n\n", "has no formats"},
                           {"G(3)\n11\t \n", ":2: label '11' has no format behind it"},
                           {std::string("G(3)\nG(\0)", 9), ":2: a line should be text"},
                           {std::string(5000, 'G'), ":1: a line should have at most 4096 characters"}};
  for (const BadList &bad : lists) {
    const auto list = readFile(bad.text);
    ASSERT_FALSE(list) << bad.message;
    EXPECT_EQ(list.error().kind, ErrorKind::Input);
    EXPECT_THAT(list.error().message, HasSubstr(bad.message));
  }
}

TEST(FormatList, tellsThatThereIsNoSuchFile) {
  const auto list = readFormatList("nowhere/paper.txt");
  ASSERT_FALSE(list);
  EXPECT_THAT(list.error().message, HasSubstr("neither a format nor a list"));
}

} // namespace
} // namespace voxc::tool
