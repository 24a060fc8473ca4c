// What a command can be given, and what it was given. CLI11 parses; its header takes longer to compile than
// most of our files, so that only the files behind this one, and those that go through all commands, include
// it.
#pragma once

#include "Option.h"

#include "voxc/Support/Error.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace voxc::tool {

/// A program or one of its commands. A handle too: copies mean the same command.
class CommandLine {
public:
  /// Takes options alone: the line of no program, which parse() is given.
  CommandLine();
  /// A program; its help is wrapped to the terminal.
  CommandLine(const std::string &name, const std::string &text);

  /// An option "-s,--long", or a word "NAME", whose value goes to `value`; where it is not given, `value`
  /// stays. For strings, numbers, std::optional of both, and vectors of both (see the end of
  /// CommandLine.cpp).
  template <typename Value> Option add(const std::string &names, Value &value, const std::string &text) const;
  /// An option whose values given() tells.
  Option add(const std::string &names, const std::string &text) const;
  /// An option whose value goes to `take` as soon as it is read.
  Option addTaken(const std::string &names, const std::function<void(const std::string &)> &take,
                  const std::string &text) const;
  Option addFlag(const std::string &names, bool &value, const std::string &text) const;
  /// A flag of which given() tells.
  Option addFlag(const std::string &names, const std::string &text) const;
  /// A flag that does something.
  Option addFlag(const std::string &names, const std::function<void()> &act, const std::string &text) const;
  /// An option of earlier versions: no help has it, and who gives it is told what there is now.
  void addFormer(const std::string &name, const std::string &now) const;
  /// --version.
  void addVersion(const std::string &version) const;
  /// A command of this one, in a group of its help.
  CommandLine addCommand(const std::string &name, const std::string &text,
                         const std::string &group = "Subcommands") const;
  /// How many of its commands must and may be given.
  void requireCommands(std::size_t least, std::size_t most) const;
  /// What its help ends with; commands that are added later take it over.
  void footer(const std::string &text) const;
  std::string footer() const;
  void remove(Option option) const;
  /// Is asked after parsing whether all that was given goes together.
  void checkTogether(const std::function<Expected<void>()> &check) const;

  /// What it is a command of; nothing for a program.
  std::optional<CommandLine> parent() const;
  std::vector<CommandLine> commands() const;
  /// The group of its own in its program's help; "" if it is not shown.
  std::string group() const;
  /// Those of its options, in the order of its help.
  std::vector<std::string> groups() const;
  std::string name() const;
  std::string text() const;
  /// The option of this name, which must exist.
  Option option(const std::string &name) const;
  /// The option of this name, if there is one.
  std::optional<Option> find(std::string_view name) const;
  /// Those of earlier versions left out.
  std::vector<Option> options() const;
  /// An option for each time that one was given, in order.
  std::vector<Option> given() const;
  /// Was this command given?
  bool isGiven() const;

  /// Takes words such as "--size=64". Error: usage, as CLI11 says it.
  Expected<void> parse(const std::vector<std::string> &words) const;

  /// For what parses it.
  CLI::App &app() const { return *app_; }

private:
  explicit CommandLine(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}
  std::shared_ptr<CLI::App> app_;
};

/// Options that are added to a command while this lives stand in the group `name` of its help.
class OptionGroup {
public:
  OptionGroup(const CommandLine &command, const std::string &name);
  ~OptionGroup();
  OptionGroup(const OptionGroup &) = delete;
  OptionGroup &operator=(const OptionGroup &) = delete;

private:
  CommandLine command_;
  std::string before_;
};

} // namespace voxc::tool
