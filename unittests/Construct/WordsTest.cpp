// The words of volumes stay what they are: a list of digests in Golden/words.txt, whose head says how it is
// made.
#include "GoldenWords.h"
#include "TestLength.h"

#include "Volume/Checksum.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Input/Input.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

namespace voxc {
namespace {

using test::Golden;
using test::kGoldenWords;

/// Compiling takes most of the time, so that short tests take every third format and no volume of very many
/// words.
constexpr int kEvery = 3;
constexpr std::uint64_t kManyWords = std::uint64_t{1} << 26;

bool isLongTest() { return test::rounds(1) > 1; }

/// One of several parts of the list, whole formats, for machines that cannot have all in one process.
struct Part {
  int number = 0;
  int count = 1;
};

/// As VOXC_WORDS_PART says it, "0/4" to "3/4"; without it, the whole list.
Part partOfList() {
  const char *const text = std::getenv("VOXC_WORDS_PART");
  Part part;
  if (text && (std::sscanf(text, "%d/%d", &part.number, &part.count) != 2 || part.number < 0 ||
               part.number >= part.count)) {
    ADD_FAILURE() << "VOXC_WORDS_PART should be as 0/4, not " << text;
    return {};
  }
  return part;
}

std::string print(const Golden &golden) {
  std::ostringstream line;
  line << std::left << std::setw(16) << golden.digest << std::right << std::setw(11) << golden.words << ' '
       << std::left << std::setw(20) << golden.scene << ' ' << std::setw(29) << golden.passes << ' '
       << golden.format;
  return line.str();
}

std::string digestOf(std::span<const std::uint32_t> words) {
  Checksum checksum;
  checksum.add(words.data(), words.size_bytes());
  std::ostringstream hex;
  hex << std::hex << std::setfill('0') << std::setw(16) << checksum.digest();
  return hex.str();
}

/// Goes over the lines of the list in their order; the code of a format is kept for the lines that follow.
class GoldenBuilder {
public:
  /// True if the line is left to long tests, or to another part.
  bool leavesOut(const Golden &golden) {
    if (golden.format + golden.passes != std::exchange(lastFormat_, golden.format + golden.passes))
      ++formats_;
    if (formats_ % part_.count != part_.number)
      return true;
    return !isLongTest() && (formats_ % kEvery != 0 || golden.words > kManyWords);
  }

  /// The line as it would be if it were written now.
  Expected<Golden> build(const Golden &golden) {
    const auto format = test::formatOf(golden);
    if (!format)
      return format.error();
    if (!constructor_ || printIr(*format) != ir_) {
      auto compiled = Constructor::compile(*format);
      if (!compiled)
        return compiled.error();
      constructor_.emplace(std::move(*compiled));
      ir_ = printIr(*format);
    }
    const auto source = test::openScene(golden.scene, format->extent());
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
  Part part_ = partOfList();
  std::string lastFormat_;
  int formats_ = 0; ///< Seen so far.
  std::string ir_;  ///< Of what is compiled.
  std::optional<Constructor> constructor_;
};

void writeListAnew() {
  GoldenBuilder builder;
  std::string text;
  for (const std::string &line : test::linesOf(kGoldenWords)) {
    const auto golden = test::parseGolden(line);
    if (!golden) {
      text += line + "\n";
      continue;
    }
    const auto now = builder.build(*golden);
    ASSERT_TRUE(now) << line << ": " << now.error().message;
    text += print(*now) + "\n";
  }
  ASSERT_TRUE(writeFile(kGoldenWords, text));
}

void compareWithList() {
  GoldenBuilder builder;
  int volumes = 0;
  int number = 0;
  for (const std::string &line : test::linesOf(kGoldenWords)) {
    ++number;
    const auto golden = test::parseGolden(line);
    if (!golden || builder.leavesOut(*golden))
      continue;
    ++volumes;
    const auto now = builder.build(*golden);
    ASSERT_TRUE(now) << "line " << number << ": " << now.error().message;
    EXPECT_EQ(print(*now), print(*golden)) << "line " << number;
  }
  EXPECT_GT(volumes, std::getenv("VOXC_WORDS_PART") ? 0 : 150);
  if (std::getenv("VOXC_WORDS_PART"))
    std::printf("%d volumes of part %s\n", volumes, std::getenv("VOXC_WORDS_PART"));
}

TEST(Words, AreThoseOfTheList) {
  if (std::getenv("VOXC_UPDATE_GOLDEN"))
    writeListAnew();
  else
    compareWithList();
}

} // namespace
} // namespace voxc
