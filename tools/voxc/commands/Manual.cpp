// voxc manual: a page of the manual for each command, from the tables that its help is printed from.
#include "common/Help.h"
#include "common/ManualPage.h"
#include "help/Examples.h"
#include "options/Outputs.h"
#include "program/Subcommand.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace voxc::tool {

namespace {

std::string exampleSection(const CommandLine &command) {
  std::string text;
  for (const Example &example : examples())
    if (example.command == command.name())
      text +=
          ".PP\n" + roffText(example.does) + ":\n.PP\n.nf\n.RS\n" + roffText(example.line) + "\n.RE\n.fi\n";
  return text.empty() ? "" : roffSection("examples") + text;
}

/// The page of a command, with its examples.
std::string pageOf(const CommandLine &command) {
  ManualExtras extras{.examples = exampleSection(command)};
  if (command.find("FORMAT"))
    extras.formats = roffSection("formats") + ".nf\n" + roffText(wrap(formatHelp(), 64)) + ".fi\n";
  return manualPage(command, extras);
}

Expected<void> writePages(const CommandLine &command, const std::filesystem::path &folder) {
  VOXC_TRY(writeFile(folder / (manualName(command) + ".1"), pageOf(command)));
  for (const CommandLine &sub : command.commands())
    if (!sub.group().empty())
      VOXC_TRY(writePages(sub, folder));
  return {};
}

class ManualCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    program_ = command.parent();
    command
        .add("COMMAND", names_,
             "The command whose page is written to standard output, as 'man -l -' reads it")
        .takes("");
    command.add("-o,--output", folder_, "Writes the pages of all commands to files in this folder")
        .takes("DIR");
    addCommonOptions(command, common_);
    command.remove(command.option("--stats")); // A page has no figures.
  }

  Expected<void> run() override {
    if (!folder_.empty())
      return writeAll();
    CommandLine command = *program_;
    for (const std::string &name : names_) {
      const std::vector<CommandLine> subs = command.commands();
      const auto found = std::ranges::find(subs, name, &CommandLine::name);
      if (found == subs.end())
        return Error::usage("there is no command '" + spokenName(command) + " " + name +
                            "'; 'voxc --help' lists them");
      command = *found;
    }
    const std::string page = pageOf(command);
    std::fwrite(page.data(), 1, page.size(), stdout);
    return {};
  }

private:
  Expected<void> writeAll() {
    if (!names_.empty())
      return Error::usage("--output writes the pages of all commands; leave out '" + names_.front() + "'");
    std::error_code failure;
    std::filesystem::create_directories(folder_, failure);
    if (failure)
      return Error::environment("cannot make the folder '" + folder_ + "': " + failure.message());
    return writePages(*program_, folder_);
  }

  std::optional<CommandLine> program_;
  std::vector<std::string> names_;
  std::string folder_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeManualCommand() { return std::make_unique<ManualCommand>(); }

} // namespace voxc::tool
