// Writing pages of the manual.
#include "ManualPage.h"

#include "Command.h"

#include <cctype>

namespace voxc::tool {
namespace {

std::string upper(std::string text) {
  for (char &c : text)
    c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// A paragraph that hangs below its tag.
std::string tagged(std::string_view tag, std::string_view text) {
  return ".TP\n.B " + roffText(tag) + "\n" + roffText(text) + "\n";
}

std::string synopsis(const CommandLine &command) {
  std::string text = roffSection("synopsis") + ".B " + roffText(spokenName(command)) + "\n[options]\n";
  for (const Option &option : command.options())
    if (option.isWord())
      text += ".I " + roffText(option.isRequired() ? option.name() : "[" + option.name() + "]") + "\n";
  if (!command.commands().empty())
    text += ".I command\n";
  return text;
}

/// The options of a command by their groups, as its help has them.
std::string optionSections(const CommandLine &command) {
  std::string text;
  for (const Option &option : command.options())
    if (option.isWord())
      text += (text.empty() ? roffSection("arguments") : "") + tagged(option.name(), option.text());
  for (const std::string &group : command.groups()) {
    std::string rows;
    for (const Option &option : command.options())
      if (option.group() == group && !option.isWord())
        rows += tagged(option.usage(), option.text());
    if (!rows.empty() && !group.empty())
      text += roffSection(group) + rows;
  }
  return text;
}

std::string commandSection(const CommandLine &command) {
  std::string text;
  for (const CommandLine &sub : command.commands())
    if (!sub.group().empty())
      text += tagged(sub.name(), sub.text() + "; " + manualName(sub) + "(1)");
  return text.empty() ? "" : roffSection("commands") + text;
}

constexpr const char *kExitSection =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone\n"
    ".TP\n1\nthe input is wrong, or a check failed\n"
    ".TP\n2\nthe command line is wrong\n"
    ".TP\n3\nthe machine lacks something: a device, a permission, disk space\n"
    ".TP\n130\ninterrupted\n";

} // namespace

std::string roffText(std::string_view text) {
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

std::string roffSection(const std::string &name) { return ".SH " + upper(roffText(name)) + "\n"; }

std::string manualName(const CommandLine &command) {
  const std::optional<CommandLine> program = command.parent();
  return (program ? manualName(*program) + "-" : "") + command.name();
}

std::string spokenName(const CommandLine &command) {
  const std::optional<CommandLine> program = command.parent();
  return (program ? spokenName(*program) + " " : "") + command.name();
}

std::string manualPage(const CommandLine &command, const ManualExtras &extras) {
  const std::string name = manualName(command);
  std::string text = ".TH " + upper(roffText(name)) + " 1 \"\" \"" + versionText() + "\" \"User commands\"\n";
  text +=
      roffSection("name") + roffText(name) + " \\- " + roffText(command.text()) + "\n" + synopsis(command);
  text += extras.formats + commandSection(command) + optionSections(command) + extras.examples + kExitSection;
  const std::optional<CommandLine> program = command.parent();
  return program ? text + roffSection("see also") + ".BR " + manualName(*program) + " (1)\n" : text;
}

void addManual(const CommandLine &program) {
  program.addFlag("--manual", "Write the manual page of this program, as 'man -l -' reads it");
}

} // namespace voxc::tool
