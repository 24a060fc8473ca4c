// voxc manual: a page of the manual for each command, from the tables that its help is printed from.
#include "Examples.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Help.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace voxc::tool {

namespace {

/// Text as roff takes it.
std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
      escaped += std::string("\\&") + c; // No request begins here.
    else
      escaped += c;
  }
  return escaped;
}

std::string upper(std::string text) {
  for (char &c : text)
    c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string section(const std::string &name) { return ".SH " + upper(escape(name)) + "\n"; }

/// A paragraph that hangs below its tag.
std::string tagged(std::string_view tag, std::string_view text) {
  return ".TP\n.B " + escape(tag) + "\n" + escape(text) + "\n";
}

std::string pageName(const CommandLine &command) {
  const std::optional<CommandLine> program = command.parent();
  return (program ? pageName(*program) + "-" : "") + command.name();
}

std::string spokenName(const CommandLine &command) {
  const std::optional<CommandLine> program = command.parent();
  return (program ? spokenName(*program) + " " : "") + command.name();
}

std::string synopsis(const CommandLine &command) {
  std::string text = section("synopsis") + ".B " + escape(spokenName(command)) + "\n[options]\n";
  for (const Option &option : command.options())
    if (option.isWord())
      text += ".I " + escape(option.isRequired() ? option.name() : "[" + option.name() + "]") + "\n";
  if (!command.commands().empty())
    text += ".I command\n";
  return text;
}

/// The options of a command by their groups, as its help has them.
std::string optionSections(const CommandLine &command) {
  std::string text;
  for (const Option &option : command.options())
    if (option.isWord())
      text += (text.empty() ? section("arguments") : "") + tagged(option.name(), option.text());
  for (const std::string &group : command.groups()) {
    std::string rows;
    for (const Option &option : command.options())
      if (option.group() == group && !option.isWord())
        rows += tagged(option.usage(), option.text());
    if (!rows.empty() && !group.empty())
      text += section(group) + rows;
  }
  return text;
}

std::string commandSection(const CommandLine &command) {
  std::string text;
  for (const CommandLine &sub : command.commands())
    if (!sub.group().empty())
      text += tagged(sub.name(), sub.text() + "; " + pageName(sub) + "(1)");
  return text.empty() ? "" : section("commands") + text;
}

std::string exampleSection(const CommandLine &command) {
  std::string text;
  for (const Example &example : examples())
    if (example.command == command.name())
      text += ".PP\n" + escape(example.does) + ":\n.PP\n.nf\n.RS\n" + escape(example.line) + "\n.RE\n.fi\n";
  return text.empty() ? "" : section("examples") + text;
}

constexpr const char *kExitSection =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone\n"
    ".TP\n1\nthe input is wrong, or a check failed\n"
    ".TP\n2\nthe command line is wrong\n"
    ".TP\n3\nthe machine lacks something: a device, a permission, disk space\n"
    ".TP\n130\ninterrupted\n";

/// A whole page.
std::string pageOf(const CommandLine &command) {
  const std::string name = pageName(command);
  std::string text = ".TH " + upper(escape(name)) + " 1 \"\" \"" + versionText() + "\" \"User commands\"\n";
  text += section("name") + escape(name) + " \\- " + escape(command.text()) + "\n" + synopsis(command);
  if (command.find("FORMAT"))
    text += section("formats") + ".nf\n" + escape(wrap(formatHelp(), 64)) + ".fi\n";
  text += commandSection(command) + optionSections(command) + exampleSection(command) + kExitSection;
  const std::optional<CommandLine> program = command.parent();
  return program ? text + section("see also") + ".BR " + pageName(*program) + " (1)\n" : text;
}

Expected<void> writePages(const CommandLine &command, const std::filesystem::path &folder) {
  if (Expected<void> written = writeFile(folder / (pageName(command) + ".1"), pageOf(command)); !written)
    return written;
  for (const CommandLine &sub : command.commands())
    if (!sub.group().empty())
      if (Expected<void> written = writePages(sub, folder); !written)
        return written;
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
