// The words of volumes stay what they are: a list of digests in Golden/words.txt, whose head says how it is
// made.
#include "TestLength.h"
#include "testing/HardScenes.h"

#include "Volume/Checksum.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Input/Input.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

namespace voxc {
namespace {

constexpr const char *kList = VOXC_UNITTESTS_DIR "/Construct/Golden/words.txt";
/// Compiling takes most of the time, so that short tests take every third format and no volume of very many
/// words.
constexpr int kEvery = 3;
constexpr std::uint64_t kManyWords = std::uint64_t{1} << 26;

bool isLongTest() { return test::rounds(1) > 1; }

/// A volume of the list, and what is known of its words.
struct Golden {
  std::string digest;
  std::uint64_t words = 0;
  std::string scene;
  std::string passes; ///< With commas between them, or "-".
  std::string format;
};

/// A line that is no comment.
std::optional<Golden> parseGolden(const std::string &line) {
  Golden golden;
  std::istringstream fields(line);
  if (line.starts_with('#') || !(fields >> golden.digest))
    return std::nullopt;
  fields >> golden.words >> golden.scene >> golden.passes >> std::ws;
  std::getline(fields, golden.format);
  return golden;
}

std::string print(const Golden &golden) {
  std::ostringstream line;
  line << std::left << std::setw(16) << golden.digest << std::right << std::setw(11) << golden.words << ' '
       << std::left << std::setw(20) << golden.scene << ' ' << std::setw(29) << golden.passes << ' '
       << golden.format;
  return line.str();
}

std::vector<std::string> linesOf(const std::string &path) {
  std::vector<std::string> lines;
  const auto text = readTextFile(path);
  std::istringstream stream(text ? *text : "");
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::string digestOf(std::span<const std::uint32_t> words) {
  Checksum checksum;
  checksum.add(words.data(), words.size_bytes());
  std::ostringstream hex;
  hex << std::hex << std::setfill('0') << std::setw(16) << checksum.digest();
  return hex.str();
}

Expected<Format> formatOf(const Golden &golden) {
  auto format = parseFormat(golden.format);
  if (!format || golden.passes == "-")
    return format;
  std::vector<std::string> names;
  std::istringstream passes(golden.passes);
  for (std::string name; std::getline(passes, name, ',');)
    names.push_back(name);
  if (auto run = runPasses(*format, names); !run)
    return run.error();
  return format;
}

Expected<std::unique_ptr<VoxelSource>> openScene(const std::string &name, Int3 extent) {
  constexpr std::string_view kHard = "hard:";
  if (!name.starts_with(kHard)) {
    auto input = openInput(name, {.formatExtent = extent});
    if (!input)
      return input.error();
    return std::move(input->source);
  }
  for (const test::HardScene &scene : test::hardScenes(extent))
    if (scene.name == name.substr(kHard.size()))
      return scene.source();
  return Error::input("there is no scene '" + name + "'");
}

/// Goes over the lines of the list in their order; the code of a format is kept for the lines that follow.
class GoldenBuilder {
public:
  /// True if the line is left to long tests.
  bool leavesOut(const Golden &golden) {
    if (golden.format + golden.passes != std::exchange(lastFormat_, golden.format + golden.passes))
      ++formats_;
    return !isLongTest() && (formats_ % kEvery != 0 || golden.words > kManyWords);
  }

  /// The line as it would be if it were written now.
  Expected<Golden> build(const Golden &golden) {
    const auto format = formatOf(golden);
    if (!format)
      return format.error();
    if (!constructor_ || printIr(*format) != ir_) {
      auto compiled = Constructor::compile(*format);
      if (!compiled)
        return compiled.error();
      constructor_.emplace(std::move(*compiled));
      ir_ = printIr(*format);
    }
    const auto source = openScene(golden.scene, format->extent());
    if (!source)
      return source.error();
    const auto built = constructor_->build(**source);
    if (!built)
      return built.error();
    Golden now = golden;
    now.words = built->volume.words().size();
    now.digest = digestOf(built->volume.words());
    return now;
  }

private:
  std::string lastFormat_;
  int formats_ = 0; ///< Seen so far.
  std::string ir_;  ///< Of what is compiled.
  std::optional<Constructor> constructor_;
};

void writeListAnew() {
  GoldenBuilder builder;
  std::string text;
  for (const std::string &line : linesOf(kList)) {
    const auto golden = parseGolden(line);
    if (!golden) {
      text += line + "\n";
      continue;
    }
    const auto now = builder.build(*golden);
    ASSERT_TRUE(now) << line << ": " << now.error().message;
    text += print(*now) + "\n";
  }
  ASSERT_TRUE(writeFile(kList, text));
}

void compareWithList() {
  GoldenBuilder builder;
  int volumes = 0;
  int number = 0;
  for (const std::string &line : linesOf(kList)) {
    ++number;
    const auto golden = parseGolden(line);
    if (!golden || builder.leavesOut(*golden))
      continue;
    ++volumes;
    const auto now = builder.build(*golden);
    ASSERT_TRUE(now) << "line " << number << ": " << now.error().message;
    EXPECT_EQ(print(*now), print(*golden)) << "line " << number;
  }
  EXPECT_GT(volumes, 150);
}

TEST(Words, AreThoseOfTheList) {
  if (std::getenv("VOXC_UPDATE_GOLDEN"))
    writeListAnew();
  else
    compareWithList();
}

} // namespace
} // namespace voxc
