// voxc completion: what a shell needs to complete commands, options and their values.
#include "Subcommand.h"

#include "voxc/Support/EmbeddedFile.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>
#include <span>
#include <vector>

namespace voxc {

/// completion.bash (cmake/VoxcEmbed.cmake).
std::span<const EmbeddedFile> completionFiles();

} // namespace voxc

namespace voxc::tool {

namespace {

/// What can stand behind an option, if that is known: the names of its check "{a,b}" or of its type "a|b=a".
std::string valuesOf(const CLI::Option &option) {
  const std::string type = option.get_type_name();
  std::string values = type.substr(0, type.find('='));
  if (values.find('|') == values.npos || values.find_first_of("[:,. ") != values.npos)
    return "";
  for (char &c : values)
    if (c == '|')
      c = ' ';
  return values;
}

/// All names of an option, with its dashes.
std::vector<std::string> namesOf(const CLI::Option &option) {
  std::vector<std::string> names;
  for (const std::string &name : option.get_lnames())
    names.push_back("--" + name);
  for (const std::string &name : option.get_snames())
    names.push_back("-" + name);
  return names;
}

/// The names that follow a command: of its options, or of its commands too.
std::string wordsAfter(const CLI::App &command) {
  std::string words;
  for (const CLI::App *sub : command.get_subcommands({}))
    if (!sub->get_group().empty())
      words += sub->get_name() + " ";
  for (const CLI::Option *option : command.get_options())
    if (option->nonpositional())
      for (const std::string &name : namesOf(*option))
        words += name + " ";
  if (!words.empty())
    words.pop_back();
  return words;
}

/// "build", or "bench export": what a command line begins with behind the tool's name.
void collect(const CLI::App &command, const std::string &path, std::map<std::string, const CLI::App *> &all) {
  all[path] = &command;
  for (const CLI::App *sub : command.get_subcommands({}))
    if (!sub->get_group().empty())
      collect(*sub, path.empty() ? sub->get_name() : path + " " + sub->get_name(), all);
}

/// A text with one of its words replaced.
std::string replaced(std::string text, std::string_view word, std::string_view by) {
  return text.replace(text.find(word), word.size(), by);
}

/// The script for bash: completion.bash with what follows each command, and each option that takes few
/// values.
std::string bashText(const CLI::App &root) {
  std::map<std::string, const CLI::App *> commands;
  collect(root, "", commands);
  std::map<std::string, std::string> values; // By option: those of one name have the same ones everywhere.
  std::string words, paths, choices;
  for (const auto &[path, command] : commands) {
    words += "    '" + path + "') words='" + wordsAfter(*command) + "' ;;\n";
    if (!path.empty())
      paths += (paths.empty() ? "'" : " | '") + path + "'";
    for (const CLI::Option *option : command->get_options())
      if (const std::string text = valuesOf(*option); !text.empty())
        for (const std::string &name : namesOf(*option))
          values[name] = text;
  }
  for (const auto &[name, text] : values)
    choices += "  " + name + ") words='" + text + "' ;;\n";
  words.pop_back();
  choices.pop_back();
  const std::string script(completionFiles().front().text);
  return replaced(replaced(replaced(script, "@COMMANDS@", paths), "@VALUES@", choices), "@WORDS@", words);
}

struct Shell {
  const char *name;
  std::string (*text)(const CLI::App &root);
};

constexpr Shell kShells[] = {{"bash", bashText}};

class CompletionCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    root_ = app.get_parent();
    std::vector<std::string> names;
    for (const Shell &shell : kShells)
      names.emplace_back(shell.name);
    app.add_option("SHELL", shell_, "The shell: bash")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember(names).description(""));
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    for (const Shell &shell : kShells)
      if (shell_ == shell.name)
        std::fputs(shell.text(*root_).c_str(), stdout);
    return {};
  }

private:
  const CLI::App *root_ = nullptr;
  std::string shell_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeCompletionCommand() { return std::make_unique<CompletionCommand>(); }

} // namespace voxc::tool
