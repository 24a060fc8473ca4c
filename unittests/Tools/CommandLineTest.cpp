// What options take and refuse, and what commands tell of themselves.
#include "common/CommandLine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

namespace voxc::tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string problemOf(const CommandLine &command, const std::vector<std::string> &words) {
  const Expected<void> parsed = command.parse(words);
  return parsed ? "" : parsed.error().message;
}

TEST(CommandLine, GivesValuesToTheirVariables) {
  const CommandLine command;
  std::string input;
  std::optional<double> threshold;
  std::vector<double> bounds;
  std::uint64_t size = 7, other = 8;
  bool isQuick = false;
  command.add("INPUT", input, "").required();
  command.add("--threshold", threshold, "");
  command.add("--bounds", bounds, "").list().values(3);
  command.add("--size", size, "");
  command.add("--other", other, "");
  command.addFlag("--quick", isQuick, "");
  EXPECT_EQ(problemOf(command, {"scene.obj", "--threshold=0.5", "--bounds", "1,2,3", "--quick", "--size",
                                "18446744073709551615"}),
            "");
  EXPECT_EQ(input, "scene.obj");
  EXPECT_EQ(threshold, 0.5);
  EXPECT_THAT(bounds, ElementsAre(1, 2, 3));
  EXPECT_EQ(size, ~std::uint64_t{0});
  EXPECT_EQ(other, 8u) << "not given";
  EXPECT_TRUE(isQuick);
}

TEST(CommandLine, RefusesEmptyNames) {
  const CommandLine command;
  std::string stats, volume;
  command.add("--stats", stats, "").notEmpty();
  command.addTaken("--volume", [&](const std::string &value) { volume = value; }, "").notEmpty();
  EXPECT_EQ(problemOf(command, {"--stats", "a", "--volume", "b"}), "");
  EXPECT_EQ(problemOf(command, {"--stats", ""}), "--stats: the name of the output is empty; name a file");
  EXPECT_EQ(problemOf(command, {"--volume", ""}), "--volume: the name of the output is empty; name a file");
}

TEST(CommandLine, TellsTheWordsThatGiveTheSame) {
  const CommandLine command;
  std::vector<double> bounds;
  std::vector<std::string> inputs, formats, devices;
  bool isQuick = false, waits = true;
  command.add("INPUT", inputs, "");
  const Option box = command.add("-b,--bounds", bounds, "").list().values(3);
  const Option list = command.add("--formats", formats, "").repeated();
  const Option names = command.add("--devices", devices, "").repeated().list();
  const Option quick = command.addFlag("--quick", isQuick, "");
  const Option patient = command.addFlag("!--no-wait", waits, "");
  EXPECT_EQ(problemOf(command, {"a b.obj", "--bounds=-1,2,3", "--formats", "A;B", "--formats=C,D", "--quick",
                                "--devices=cpu,x", "--devices", "y"}),
            "");
  EXPECT_THAT(command.option("INPUT").words(), ElementsAre("a b.obj"));
  EXPECT_THAT(box.words(), ElementsAre("--bounds", "-1,2,3"));
  EXPECT_THAT(list.words(), ElementsAre("--formats", "A;B", "--formats", "C,D"));
  EXPECT_THAT(names.words(), ElementsAre("--devices", "cpu,x,y"));
  EXPECT_THAT(quick.words(), ElementsAre("--quick"));
  EXPECT_THAT(patient.words(), ElementsAre());
}

TEST(CommandLine, RefusesValuesThatAreNotAllowed) {
  const CommandLine command;
  std::string up;
  unsigned count = 0;
  command.add("--up", up, "").oneOf({"y", "z"});
  command.add("--count", count, "").between(1u, 8u);
  command.add("--even", count, "").check([](const std::string &value) {
    return (value.back() - '0') % 2 == 0 ? std::string() : value + " is odd";
  });
  EXPECT_THAT(problemOf(command, {"--up=x"}), HasSubstr("--up"));
  EXPECT_THAT(problemOf(command, {"--count=9"}), HasSubstr("--count"));
  EXPECT_THAT(problemOf(command, {"--count=0"}), HasSubstr("--count"));
  EXPECT_THAT(problemOf(command, {"--even=3"}), HasSubstr("3 is odd"));
  EXPECT_EQ(problemOf(command, {"--up=z", "--count=8", "--even=2"}), "");
}

TEST(CommandLine, TakesOneValueForEachTimeAnOptionIsGiven) {
  const CommandLine command;
  std::vector<std::string> formats, inputs;
  command.add("--format", formats, "").repeated();
  command.add("INPUT", inputs, "");
  EXPECT_EQ(problemOf(command, {"--format", "G(5)", "a.obj", "--format", "S(5)"}), "");
  EXPECT_THAT(formats, ElementsAre("G(5)", "S(5)"));
  EXPECT_THAT(inputs, ElementsAre("a.obj"));
}

TEST(CommandLine, ListsTakeNotTheWordBehindThem) {
  const CommandLine command;
  std::vector<std::string> kinds;
  std::vector<double> box;
  std::string format;
  command.add("--emit", kinds, "").list();
  command.add("--window", box, "").list().values(2);
  command.add("FORMAT", format, "");
  EXPECT_EQ(problemOf(command, {"--emit", "ir,plan", "--window", "-1,2", "G(5)"}), "");
  EXPECT_THAT(kinds, ElementsAre("ir", "plan"));
  EXPECT_THAT(box, ElementsAre(-1, 2));
  EXPECT_EQ(format, "G(5)");
  EXPECT_EQ(problemOf(command, {"--window=1", "--window", "9"}), "");
}

TEST(CommandLine, SaysHowManyValuesAListTakes) {
  const CommandLine command;
  std::vector<double> sun;
  std::string format;
  command.add("--sun", sun, "").list().values(2);
  command.add("FORMAT", format, "");
  EXPECT_EQ(problemOf(command, {"--sun", "1", "2"}), "--sun: takes 2 values with commas between them, not 1");
  EXPECT_EQ(problemOf(command, {"--sun", "1,2,-3"}), "--sun: takes 2 values with commas between them, not 3");
  EXPECT_EQ(problemOf(command, {"--sun", "-1,-2"}), "");
  EXPECT_THAT(sun, ElementsAre(-1, -2));
}

TEST(CommandLine, TellsWhatWasGivenInItsOrder) {
  const CommandLine command;
  command.addFlag("--first", "");
  command.addFlag("--second", "");
  command.add("--third", "").list().repeated();
  EXPECT_EQ(problemOf(command, {"--third=a,b", "--first"}), "");
  std::vector<std::string> names;
  for (const Option &option : command.given())
    names.push_back(option.name());
  EXPECT_THAT(names, ElementsAre("--third", "--first"));
  EXPECT_THAT(command.option("--third").written(), ElementsAre("a", "b"));
  EXPECT_EQ(command.option("--second").count(), 0u);
  EXPECT_FALSE(command.find("--fourth"));
}

TEST(CommandLine, AsksWhetherAllThatWasGivenGoesTogether) {
  const CommandLine command;
  bool one = false, two = false;
  command.addFlag("--one", one, "");
  command.addFlag("--two", two, "");
  command.checkTogether([&]() -> Expected<void> {
    if (one && two)
      return Error::usage("--one excludes --two");
    return {};
  });
  EXPECT_EQ(problemOf(command, {"--one"}), "");
  EXPECT_EQ(problemOf(command, {"--one", "--two"}), "--one excludes --two");
}

TEST(CommandLine, CommandsKnowTheirProgram) {
  const CommandLine program("voxc", "A compiler");
  const CommandLine build = program.addCommand("build", "Builds", "Making");
  std::string output;
  build.add("-o,--output", output, "File").takes("FILE").required();
  {
    const OptionGroup group(build, "Memory");
    bool isSmall = false;
    build.addFlag("--small", isSmall, "Less");
  }
  EXPECT_EQ(build.parent()->name(), "voxc");
  EXPECT_FALSE(program.parent());
  ASSERT_EQ(program.commands().size(), 1u);
  EXPECT_EQ(program.commands()[0].group(), "Making");
  const Option option = build.option("-o");
  EXPECT_THAT(option.names(), ElementsAre("--output", "-o"));
  EXPECT_EQ(option.name(), "--output");
  EXPECT_EQ(option.value(), "FILE");
  EXPECT_TRUE(option.takesValue());
  EXPECT_TRUE(option.isRequired());
  EXPECT_FALSE(option.isWord());
  EXPECT_EQ(build.option("--small").group(), "Memory");
  EXPECT_FALSE(build.option("--small").takesValue());
}

} // namespace
} // namespace voxc::tool
