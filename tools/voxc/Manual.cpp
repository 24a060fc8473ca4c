// voxc manual: a page of the manual for each command, from the tables that its help is printed from.
#include "Examples.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Help.h"
#include "voxc/Support/File.h"

#include <CLI/CLI.hpp>

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

std::string pageName(const CLI::App &command) {
  return command.get_parent() ? pageName(*command.get_parent()) + "-" + command.get_name()
                              : command.get_name();
}

std::string spokenName(const CLI::App &command) {
  return command.get_parent() ? spokenName(*command.get_parent()) + " " + command.get_name()
                              : command.get_name();
}

std::string synopsis(const CLI::App &command) {
  std::string text = section("synopsis") + ".B " + escape(spokenName(command)) + "\n[options]\n";
  for (const CLI::Option *option : command.get_options())
    if (option->get_positional())
      text +=
          ".I " + escape(option->get_required() ? option->get_name() : "[" + option->get_name() + "]") + "\n";
  if (!command.get_subcommands({}).empty())
    text += ".I command\n";
  return text;
}

/// The options of a command by their groups, as its help has them.
std::string optionSections(const CLI::App &command) {
  std::string text;
  if (command.get_options([](const CLI::Option *option) { return option->get_positional(); }).size() > 0)
    text += section("arguments");
  for (const CLI::Option *option : command.get_options())
    if (option->get_positional())
      text += tagged(option->get_name(), option->get_description());
  for (const std::string &group : command.get_groups()) {
    std::string rows;
    for (const CLI::Option *option : command.get_options())
      if (option->get_group() == group && option->nonpositional())
        rows += tagged(optionUsage(*option), option->get_description());
    if (!rows.empty() && !group.empty())
      text += section(group) + rows;
  }
  return text;
}

std::string commandSection(const CLI::App &command) {
  std::string text;
  for (const CLI::App *sub : command.get_subcommands({}))
    if (!sub->get_group().empty())
      text += tagged(sub->get_name(), sub->get_description() + "; " + pageName(*sub) + "(1)");
  return text.empty() ? "" : section("commands") + text;
}

std::string exampleSection(const CLI::App &command) {
  std::string text;
  for (const Example &example : examples())
    if (example.command == command.get_name())
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
std::string pageOf(const CLI::App &command) {
  const std::string name = pageName(command);
  std::string text = ".TH " + upper(escape(name)) + " 1 \"\" \"" + versionText() + "\" \"User commands\"\n";
  text +=
      section("name") + escape(name) + " \\- " + escape(command.get_description()) + "\n" + synopsis(command);
  if (command.get_option_no_throw("FORMAT"))
    text += section("formats") + ".nf\n" + escape(wrap(formatHelp(), 64)) + ".fi\n";
  text += commandSection(command) + optionSections(command) + exampleSection(command) + kExitSection;
  return command.get_parent()
             ? text + section("see also") + ".BR " + pageName(*command.get_parent()) + " (1)\n"
             : text;
}

Expected<void> writePages(const CLI::App &command, const std::filesystem::path &folder) {
  if (Expected<void> written = writeFile(folder / (pageName(command) + ".1"), pageOf(command)); !written)
    return written;
  for (const CLI::App *sub : command.get_subcommands({}))
    if (!sub->get_group().empty())
      if (Expected<void> written = writePages(*sub, folder); !written)
        return written;
  return {};
}

class ManualCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    root_ = app.get_parent();
    app.add_option("COMMAND", names_,
                   "The command whose page is written to standard output, as 'man -l -' reads it")
        ->type_name("");
    app.add_option("-o,--output", folder_, "Writes the pages of all commands to files in this folder")
        ->type_name("DIR");
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    if (!folder_.empty())
      return writeAll();
    const CLI::App *command = root_;
    for (const std::string &name : names_) {
      const auto subs = command->get_subcommands({});
      const auto found = std::ranges::find(subs, name, [](const CLI::App *sub) { return sub->get_name(); });
      if (found == subs.end())
        return Error::usage("there is no command '" + spokenName(*command) + " " + name +
                            "'; 'voxc --help' lists them");
      command = *found;
    }
    const std::string page = pageOf(*command);
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
    return writePages(*root_, folder_);
  }

  const CLI::App *root_ = nullptr;
  std::vector<std::string> names_;
  std::string folder_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeManualCommand() { return std::make_unique<ManualCommand>(); }

} // namespace voxc::tool
