// Records of cells: written, read, kept whole in files.
#include "voxc/Measure/RecordFile.h"

#include "Measure/Json.h"
#include "voxc/Support/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace voxc::measure {
namespace {

using testing::HasSubstr;

Record makeRecord(const std::string &cell) {
  Record record;
  record.cell = cell;
  record.model = {"sponza", "sponza.obj", "0123", std::array<std::uint64_t, 3>{64, 32, 16}, 99, {}};
  record.format = {"11", "R(4^3) G(7)", {"whole-level-dedup"}, "4567"};
  record.resolution = 64;
  record.precision = "exact";
  record.device = {"llvmpipe", "vulkan", "Mesa", 2, "cpu"};
  record.rays = {"sponza", "camera", 12, std::array<std::uint64_t, 2>{4, 3}, "89ab"};
  record.volume = {.words = 10, .bytes = 40, .fileBytes = {}, .bytesPerVoxel = 0.5, .levelWords = {{7, 2}}};
  record.predicted = {.words = 10, .mraysPerS = 3.5, .turns = {}, .lines = 1.25};
  record.speed.rounds = 3;
  record.speed.mraysPerCpuS = Speed{1, 2, 3, 1};
  record.speed.steady = false;
  record.error.rays = 5;
  record.madeBy = {"voxc 0.1.0", "19", "some processor", 2, "voxc bench"};
  return record;
}

std::string lineOf(const Record &record) { return toLine(record) + "\n"; }

Json jsonOf(const Record &record) { return Json::parse(toLine(record)); }

/// A folder of this test's own, empty.
class RecordFileTest : public testing::Test {
protected:
  void SetUp() override {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("voxc-records-") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string &name) const { return (folder_ / name).string(); }
  void write(const std::string &name, const std::string &text) { ASSERT_TRUE(writeFile(path(name), text)); }
  std::vector<std::string> cells() const {
    const auto records = readRecords(folder_.string());
    std::vector<std::string> names;
    if (records)
      for (const Record &record : *records)
        names.push_back(record.cell);
    return names;
  }

  std::filesystem::path folder_;
};

TEST(Record, comesBackAsItWas) {
  const std::string text = toLine(makeRecord("a"));
  const auto read = parseRecord(text);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(toLine(*read), text);
  EXPECT_TRUE(read->isMeasured());
  EXPECT_EQ(read->volume.words, 10u);
  EXPECT_EQ(read->model.size->at(1), 32u);
  EXPECT_EQ(read->speed.mraysPerCpuS->median, 2);
}

TEST(Record, leavesOutWhatWasNotTaken) {
  const Json json = jsonOf(makeRecord("a"));
  EXPECT_FALSE(json.contains("build"));
  EXPECT_FALSE(json.contains("failure"));
  EXPECT_FALSE(json["volume"].contains("file_bytes"));
  EXPECT_FALSE(json["speed"].contains("mrays_per_device_s"));
  EXPECT_FALSE(json["model"].contains("picture"));
}

TEST(Record, tellsAnOrderThatWasAskedFor) {
  Record record = makeRecord("a");
  const std::string before = cellDigest(record);
  EXPECT_EQ(titleOf(record.rays), "sponza");
  record.rays.order = "given";
  record.speed.order = "given";
  EXPECT_NE(cellDigest(record), before);
  EXPECT_EQ(titleOf(record.rays), "sponza as given");
  const auto read = parseRecord(toLine(record));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->rays.order, "given");
  EXPECT_EQ(read->speed.order, "given");
}

TEST(Record, keepsAFailureWithItsReason) {
  Record record = makeRecord("a");
  record.failure = {"build", "too large", 77};
  const auto read = parseRecord(toLine(record));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_FALSE(read->isMeasured());
  EXPECT_EQ(read->failure->stage, "build");
  EXPECT_EQ(read->failure->words, 77u);
  EXPECT_EQ(jsonOf(record)["status"], "failed");
}

TEST(Record, takesNullAsAbsent) {
  Json json = jsonOf(makeRecord("a"));
  json["status"] = "failed";
  json["failure"] = {{"stage", "parse"}, {"reason", "no format"}, {"words", nullptr}};
  const auto read = parseRecord(json.dump());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->failure->words, std::nullopt);
}

struct BrokenRecord {
  const char *name;
  void (*breakIt)(Json &json);
  const char *message;
};

class BrokenRecordTest : public testing::TestWithParam<BrokenRecord> {};

TEST_P(BrokenRecordTest, isToldByItsKey) {
  Json json = jsonOf(makeRecord("a"));
  GetParam().breakIt(json);
  const auto read = parseRecord(json.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::Input);
  EXPECT_THAT(read.error().message, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Record, BrokenRecordTest,
    testing::Values(
        BrokenRecord{"array", [](Json &json) { json = Json::array(); }, "JSON object"},
        BrokenRecord{"schema", [](Json &json) { json["schema"] = 2; }, "\"schema\": 1"},
        BrokenRecord{"missing", [](Json &json) { json["model"].erase("name"); }, "\"model.name\" is missing"},
        BrokenRecord{"section", [](Json &json) { json["model"] = 1; }, "\"model\" should be an object"},
        BrokenRecord{"negative", [](Json &json) { json["volume"]["words"] = -1; }, "\"volume.words\""},
        BrokenRecord{"size", [](Json &json) { json["model"]["size"] = {1, 2}; }, "\"model.size\""},
        BrokenRecord{"speed", [](Json &json) { json["speed"]["mrays_per_cpu_s"].erase("median"); },
                     "\"speed.mrays_per_cpu_s.median\" is missing"},
        BrokenRecord{"status", [](Json &json) { json["status"] = "failed"; }, "\"status\""},
        BrokenRecord{"passes", [](Json &json) { json["format"]["passes"] = {1}; }, "\"format.passes\""}),
    [](const auto &test) { return std::string(test.param.name); });

TEST(Record, speedIsThatOfTheDevicesClock) {
  Record record = makeRecord("a");
  record.speed.mraysPerDeviceS = Speed{10, 20, 30, 1};
  EXPECT_EQ(speedOf(record)->median, 2);
  record.device.clock = "gpu";
  EXPECT_EQ(speedOf(record)->median, 20);
}

TEST(Record, speedFollowsFromTheSecondsOfRounds) {
  const auto speed = speedOf(4'000'000, {1, 2, 4});
  ASSERT_TRUE(speed);
  EXPECT_DOUBLE_EQ(speed->min, 1);
  EXPECT_DOUBLE_EQ(speed->median, 2);
  EXPECT_DOUBLE_EQ(speed->max, 4);
  EXPECT_DOUBLE_EQ(speed->spread, 1.5);
  EXPECT_FALSE(speedOf(1, {}));
}

TEST_F(RecordFileTest, laterLinesAndFilesCount) {
  Record again = makeRecord("a");
  again.precision = "fast";
  write("1.jsonl", lineOf(makeRecord("a")) + lineOf(makeRecord("b")));
  write("2.jsonl", lineOf(again) + "\n");
  write("other.json", "no record");
  const auto records = readRecords(folder_.string());
  ASSERT_TRUE(records) << records.error().message;
  EXPECT_EQ(cells(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(records->front().precision, "fast");
}

TEST_F(RecordFileTest, cutLineIsLeftOut) {
  write("1.jsonl", lineOf(makeRecord("a")) + lineOf(makeRecord("b")).substr(0, 40));
  EXPECT_EQ(cells(), std::vector<std::string>{"a"});
}

TEST_F(RecordFileTest, brokenLineIsToldByItsNumber) {
  write("1.jsonl", lineOf(makeRecord("a")) + "{}\n");
  const auto records = readRecords(folder_.string());
  ASSERT_FALSE(records);
  EXPECT_THAT(records.error().message, HasSubstr("1.jsonl:2: "));
}

TEST_F(RecordFileTest, missingFolderIsAnError) { EXPECT_FALSE(readRecords(path("nowhere"))); }

TEST_F(RecordFileTest, writerRemovesACutLineAndAppends) {
  write(kResultsName, lineOf(makeRecord("a")) + "{\"schema\"");
  auto writer = RecordWriter::open(path(kResultsName));
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE(writer->append(makeRecord("b")));
  EXPECT_EQ(cells(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(*readTextFile(path(kResultsName)), lineOf(makeRecord("a")) + lineOf(makeRecord("b")));
}

TEST_F(RecordFileTest, onlyOneWriterAtATime) {
  auto writer = RecordWriter::open(path(kResultsName));
  ASSERT_TRUE(writer);
  const auto second = RecordWriter::open(path(kResultsName));
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another voxc"));
}

TEST_F(RecordFileTest, takesTheRecordsOfAnotherFile) {
  write("share.jsonl", lineOf(makeRecord("b")) + lineOf(makeRecord("c")) + "{\"schema\"");
  auto writer = RecordWriter::open(path(kResultsName));
  ASSERT_TRUE(writer && writer->append(makeRecord("a")));
  ASSERT_TRUE(writer->take(path("share.jsonl")));
  EXPECT_EQ(*readTextFile(path(kResultsName)),
            lineOf(makeRecord("a")) + lineOf(makeRecord("b")) + lineOf(makeRecord("c")));
  EXPECT_FALSE(readTextFile(path("share.jsonl"))) << "it should be gone";
}

TEST_F(RecordFileTest, leavesAFileThatIsWritten) {
  auto writer = RecordWriter::open(path(kResultsName));
  auto other = RecordWriter::open(path("share.jsonl"));
  ASSERT_TRUE(writer && other && other->append(makeRecord("b")));
  ASSERT_TRUE(writer->take(path("share.jsonl")));
  EXPECT_EQ(*readTextFile(path(kResultsName)), "");
  const auto records = readRecordFile(path("share.jsonl"));
  ASSERT_TRUE(records);
  EXPECT_EQ(records->size(), 1u);
  EXPECT_TRUE(readRecordFile(path("none.jsonl"))->empty());
}

} // namespace
} // namespace voxc::measure
