// The page as a whole: what it holds, what it leaves out, and that no record can put code into it.
#include "MakeCell.h"

#include "common/SmallPicture.h"
#include "report/Report.h"
#include "report/Thumbnail.h"

#include "common/Png.h"
#include "voxc/Support/File.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace voxc::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

const std::vector<std::string> kDedup = {"whole-level-dedup"};

std::size_t count(const std::string &text, const std::string &word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

std::string page(const std::vector<Cell> &cells) { return makeReport(cells).html; }

TEST(Report, HasAPointForEachSpeedAndARowForEachCell) {
  const std::string html = page({makeCell("G(11)", 100, 1), makeCell("S(11)", 500, 0.5),
                                 makeCell("R(4^3) G(7)", 200, 2), makeFailure("R(8^3) G(3)", "too large")});
  EXPECT_EQ(count(html, "<a class=\"point"), 3u);
  EXPECT_EQ(count(html, " on\" href=\"#r"), 2u); // G(11) and R(4^3) G(7)
  EXPECT_EQ(count(html, "<line class=\"rounds\""), 3u);
  EXPECT_EQ(count(html, "<tr id=r"), 4u);
  EXPECT_THAT(html, HasSubstr("missed 0, ghost 0, wrong 0 of 1,000 rays"));
  EXPECT_THAT(html, HasSubstr("too large (it reached 12,345 words)"));
}

TEST(Report, LeavesOutSectionsThatItHasNoRecordsFor) {
  const std::string small = page({makeCell("G(11)", 100, 1)});
  for (const char *id : {"frontier", "dedup", "restart", "unroll", "precision", "memory", "failures"})
    EXPECT_THAT(small, Not(HasSubstr("<div id=\"" + std::string(id) + "\">")));
  const std::string studied = page({makeCell("G(11)", 300, 1), makeCell("G(11)", 100, 1, kDedup)});
  EXPECT_THAT(studied, HasSubstr("<div id=\"dedup\">"));
  EXPECT_THAT(studied, HasSubstr("3.00×"));
}

TEST(Report, IsMadeOfFailuresAloneToo) {
  const std::string html = page({makeFailure("G(99)", "too large")});
  EXPECT_THAT(html, HasSubstr("<div id=\"failures\">"));
  EXPECT_THAT(html, Not(HasSubstr("<div id=\"models\">")));
}

TEST(Report, ComparesFrontiersOfModelsThatHaveSpeeds) {
  std::vector<Cell> cells(2, makeCell("G(11)", 100, 1));
  cells[1].model.name = "tower";
  EXPECT_THAT(page(cells), HasSubstr("On the frontier of every model: G(11)."));
  for (Cell &cell : cells)
    cell = makeFailure(cell.model.name == "hut" ? "G(" : "S(", "no format");
  cells[1].model.name = "tower";
  EXPECT_THAT(page(cells), Not(HasSubstr("<div id=\"frontier\">")));
}

TEST(Report, BeginsEachModelWithTheVerdict) {
  Cell small = makeCell("G(11)", 5 << 20, 1), large = makeCell("R(9^3)", 100 << 20, 4);
  small.model.input = large.model.input = "hut.obj";
  const std::string html = page({small, large, makeCell("D(9^3, 6)", 120 << 20, 3.99)});
  EXPECT_LT(html.find("<dt>Smallest</dt>"), html.find("<svg class=\"chart"));
  EXPECT_THAT(html, HasSubstr("<b>G(11)</b>, 5.00 MiB: 1.00 Mrays/CPU s on llvmpipe."));
  EXPECT_THAT(html, HasSubstr("<code>voxc build 'G(11)' hut.obj -o hut.hvx</code>"));
  EXPECT_THAT(html, HasSubstr("As fast, within the spread: <span class=\"name\">D(9³, 6)</span>."));
}

TEST(Report, NamesSpeedsThatAreNotSteady) {
  Cell cell = makeCell("G(11)", 100, 1);
  cell.speed.steady = false;
  EXPECT_THAT(page({cell}), HasSubstr("Not steady: <span class=\"name\">G(11)</span>."));
}

TEST(Report, TellsWhatASearchForetold) {
  std::vector<Cell> cells = {makeCell("G(11)", 400, 1), makeCell("S(11)", 800, 2)};
  EXPECT_THAT(page(cells), Not(HasSubstr("<div id=\"predictions\">")));
  for (Cell &cell : cells) {
    cell.predicted = {
        .words = 100, .mraysPerS = cell.speed.mraysPerCpuS->median * 1.1, .turns = {}, .lines = {}};
    cell.volume.words = 100;
  }
  EXPECT_THAT(page(cells), HasSubstr("2 speeds: median error 10.0 %, rank correlation 1.00."));
  EXPECT_THAT(page(cells), HasSubstr("All 2 sizes are as foretold, to the word."));
  cells[1].volume.words = 103;
  EXPECT_THAT(page(cells), HasSubstr("the others are off by 3 words at most."));
}

TEST(Report, TellsTheBytesOfEachLevelOfALeader) {
  Cell cell = makeCell("R(4^3) G(7)", 4096, 1);
  cell.volume.levelWords = {{24, 1000}};
  EXPECT_THAT(page({cell}), HasSubstr("<small>R(4³) 96.0 B · G(7) 3.91 KiB</small>"));
  cell.volume.levelWords = {{24}};
  EXPECT_THAT(page({cell}), Not(HasSubstr("levels-bar\"")));
}

TEST(Report, LinksToItsFigures) {
  const std::vector<Cell> cells = {makeCell("G(11)", 100, 1)};
  EXPECT_THAT(page(cells), Not(HasSubstr(".csv")));
  EXPECT_THAT(makeReport(cells, {}, "a b.csv").html, HasSubstr("<a href=\"./a%20b.csv\">a b.csv</a>"));
}

TEST(Report, PaintsNoMemoryThatIsAboutTheSame) {
  std::vector<Cell> cells = {makeCell("G(11)", 100, 1), makeCell("S(11)", 100, 1)};
  cells[0].build.peakRssBytes = 169 << 20;
  cells[1].build.peakRssBytes = 174 << 20;
  EXPECT_THAT(page(cells), HasSubstr("all of 2 formats need about the same, 169 MiB to 174 MiB."));
  cells[1].build.peakRssBytes = 400 << 20;
  EXPECT_THAT(page(cells), HasSubstr("class=\"bar worse\""));
}

TEST(Report, RingsPointsWithErrors) {
  Cell cell = makeCell("G(11)", 100, 1);
  EXPECT_THAT(page({cell}), Not(HasSubstr("class=\"ring\"")));
  cell.error.wrong = 1;
  EXPECT_THAT(page({cell}), HasSubstr("class=\"ring\""));
}

TEST(Report, EscapesWhatRecordsSay) {
  const std::string evil = "<script>alert(1)</script>\"'{{style}}";
  Cell cell = makeCell(evil, 100, 1, {evil});
  cell.model.name = cell.precision = cell.device.name = cell.device.kind = cell.device.driver = evil;
  cell.rays.name = cell.format.label = evil;
  cell.madeBy = {evil, evil, evil, 2, evil};
  Cell failed = makeFailure(evil, evil);
  failed.failure->stage = evil;
  failed.rays.name = evil + "2";
  Cell plain = cell;
  plain.format.passes.clear();
  const std::string html = page({cell, plain, failed});
  EXPECT_EQ(count(html, "<script>"), 1u);
  EXPECT_EQ(count(html, "</script>"), 1u);
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)"));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
}

TEST(Report, LoadsNothing) {
  const std::string html = page({makeCell("G(11)", 100, 1)});
  for (const char *word : {"http:", "https:", "@import", "url(", "<link", "src="})
    EXPECT_THAT(html, Not(HasSubstr(word)));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

class PictureTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "voxc-report-pictures";
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string &name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(PictureTest, AreShrunkToMeans) {
  const Picture picture{4, 2, {0xff000000u, 0xff0000ffu, 1, 1, 0xff000000u, 0xff0000ffu, 3, 3}};
  const Picture small = tool::shrunk(picture, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.pixels, (std::vector<std::uint32_t>{0xff000080u, 0xff000002u}));
  EXPECT_EQ(tool::shrunk(picture, 4).pixels, picture.pixels);
}

TEST_F(PictureTest, LieInThePageWithinABound) {
  ASSERT_TRUE(tool::writePng(path("a.png"), {32, 16, std::vector<std::uint32_t>(512, 0xff204080u)}));
  const auto address = thumbnail(path("a.png"), 90'000);
  ASSERT_TRUE(address);
  EXPECT_THAT(*address, StartsWith("data:image/jpeg;base64,/9j/"));
  EXPECT_EQ((address->size() - std::string("data:image/jpeg;base64,").size()) % 4, 0u);
  EXPECT_FALSE(thumbnail(path("a.png"), 100));
  EXPECT_FALSE(thumbnail(path("none.png"), 90'000));
}

TEST_F(PictureTest, ThatCannotBeReadAreNoted) {
  ASSERT_TRUE(writeFile(path("a.png"), "no picture"));
  Cell cell = makeCell("G(11)", 100, 1);
  cell.model.picture = path("a.png");
  const Report report = makeReport({cell});
  EXPECT_THAT(report.notes, SizeIs(1));
  EXPECT_THAT(report.html, Not(HasSubstr("<img")));
}

TEST_F(PictureTest, AreNotTakenFromOutsideTheirFolder) {
  Cell cell = makeCell("G(11)", 100, 1);
  std::string lines;
  for (const char *picture : {"pictures/a.png", "../a.png", "/a.png"}) {
    cell.cell = std::string("cell of ") + picture;
    cell.model.picture = picture;
    lines += toJson(cell).dump() + "\n";
  }
  ASSERT_TRUE(writeFile(path("records.jsonl"), lines));
  const auto cells = readCells({folder_.string()});
  ASSERT_TRUE(cells);
  EXPECT_EQ((*cells)[0].model.picture, path("pictures/a.png"));
  EXPECT_FALSE((*cells)[1].model.picture || (*cells)[2].model.picture);
}

TEST_F(PictureTest, RecordsOfLaterFoldersCount) {
  Cell cell = makeCell("G(11)", 100, 1);
  cell.cell = "same";
  std::filesystem::create_directories(folder_ / "later");
  ASSERT_TRUE(writeFile(path("records.jsonl"), toJson(cell).dump() + "\n"));
  cell.volume.bytes = 50;
  ASSERT_TRUE(writeFile(path("later/records.jsonl"), toJson(cell).dump() + "\n"));
  const auto cells = readCells({folder_.string(), path("later")});
  ASSERT_TRUE(cells);
  ASSERT_THAT(*cells, SizeIs(1));
  EXPECT_EQ((*cells)[0].volume.bytes, 50u);
  EXPECT_FALSE(readCells({path("none")}));
}

} // namespace
} // namespace voxc::report
