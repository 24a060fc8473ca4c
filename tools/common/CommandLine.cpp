// Commands of CLI11.
#include "CommandLine.h"

#include "Help.h"

#include <CLI/CLI.hpp>

#include <cstdint>

namespace voxc::tool {
namespace {

std::vector<Option> handlesOf(const std::vector<CLI::Option *> &options) {
  std::vector<Option> handles;
  handles.reserve(options.size());
  for (CLI::Option *option : options)
    handles.emplace_back(*option);
  return handles;
}

} // namespace

CommandLine::CommandLine() : app_(std::make_shared<CLI::App>()) {}

CommandLine::CommandLine(const std::string &name, const std::string &text)
    : app_(std::make_shared<CLI::App>(text, name)) {
  useWrappedHelp(*app_);
}

template <typename Value>
Option CommandLine::add(const std::string &names, Value &value, const std::string &text) const {
  return Option(*app_->add_option(names, value, text));
}

Option CommandLine::add(const std::string &names, const std::string &text) const {
  return Option(*app_->add_option(names)->description(text));
}

Option CommandLine::addTaken(const std::string &names, const std::function<void(const std::string &)> &take,
                             const std::string &text) const {
  return Option(*app_->add_option_function<std::string>(names, take, text)->trigger_on_parse());
}

Option CommandLine::addFlag(const std::string &names, bool &value, const std::string &text) const {
  return Option(*app_->add_flag(names, value, text));
}

Option CommandLine::addFlag(const std::string &names, const std::string &text) const {
  return Option(*app_->add_flag(names)->description(text));
}

Option CommandLine::addFlag(const std::string &names, const std::function<void()> &act,
                            const std::string &text) const {
  return Option(*app_->add_flag_callback(names, act, text));
}

void CommandLine::addFormer(const std::string &name, const std::string &now) const {
  const auto refuse = [name, now](const std::string &) -> void {
    throw CLI::ValidationError(name, "is " + now + " now");
  };
  app_->add_option_function<std::string>(name, refuse)->group("")->expected(0, 1)->trigger_on_parse();
}

void CommandLine::addVersion(const std::string &version) const {
  app_->set_version_flag("--version", version, "Print the version and exit");
}

CommandLine CommandLine::addCommand(const std::string &name, const std::string &text,
                                    const std::string &group) const {
  // It lives in its program, and keeps that alive.
  return CommandLine(std::shared_ptr<CLI::App>(app_, app_->add_subcommand(name, text)->group(group)));
}

void CommandLine::requireCommands(std::size_t least, std::size_t most) const {
  app_->require_subcommand(least, most);
}

void CommandLine::footer(const std::string &text) const { app_->footer(text); }

std::string CommandLine::footer() const { return app_->get_footer(); }

void CommandLine::remove(Option option) const { app_->remove_option(option.option_); }

void CommandLine::checkTogether(const std::function<Expected<void>()> &check) const {
  app_->parse_complete_callback([check] {
    if (const Expected<void> checked = check(); !checked)
      throw CLI::ValidationError(checked.error().message);
  });
}

std::optional<CommandLine> CommandLine::parent() const {
  if (CLI::App *const parent = app_->get_parent())
    return CommandLine(std::shared_ptr<CLI::App>(app_, parent));
  return std::nullopt;
}

std::vector<CommandLine> CommandLine::commands() const {
  std::vector<CommandLine> commands;
  for (CLI::App *const command : app_->get_subcommands({}))
    commands.push_back(CommandLine(std::shared_ptr<CLI::App>(app_, command)));
  return commands;
}

std::string CommandLine::group() const { return app_->get_group(); }

std::vector<std::string> CommandLine::groups() const { return app_->get_groups(); }

std::string CommandLine::name() const { return app_->get_name(); }

std::string CommandLine::text() const { return app_->get_description(); }

Option CommandLine::option(const std::string &name) const { return Option(*app_->get_option(name)); }

std::optional<Option> CommandLine::find(std::string_view name) const {
  CLI::Option *const option = app_->get_option_no_throw(std::string(name));
  return option ? std::optional<Option>(Option(*option)) : std::nullopt;
}

std::vector<Option> CommandLine::options() const {
  return handlesOf(app_->get_options([](const CLI::Option *option) { return !option->get_group().empty(); }));
}

std::vector<Option> CommandLine::given() const { return handlesOf(app_->parse_order()); }

bool CommandLine::isGiven() const { return app_->parsed(); }

Expected<void> CommandLine::parse(const std::vector<std::string> &words) const {
  try {
    app_->parse(std::vector<std::string>(words.rbegin(), words.rend())); // CLI11 takes them from the back.
  } catch (const CLI::ParseError &failure) {
    return Error::usage(failure.what());
  }
  return {};
}

OptionGroup::OptionGroup(const CommandLine &command, const std::string &name)
    : command_(command), before_(command.app().option_defaults()->get_group()) {
  command_.app().option_defaults()->group(name);
}

OptionGroup::~OptionGroup() { command_.app().option_defaults()->group(before_); }

// What options are in our programs.

// A type cannot stand in parentheses here. NOLINTBEGIN(bugprone-macro-parentheses)
#define VOXC_OPTION_VALUE(Value)                                                                             \
  template Option CommandLine::add(const std::string &, Value &, const std::string &) const;
// NOLINTEND(bugprone-macro-parentheses)
VOXC_OPTION_VALUE(std::string)
VOXC_OPTION_VALUE(std::vector<std::string>)
VOXC_OPTION_VALUE(int)
VOXC_OPTION_VALUE(unsigned)
VOXC_OPTION_VALUE(std::uint64_t)
VOXC_OPTION_VALUE(float)
VOXC_OPTION_VALUE(double)
VOXC_OPTION_VALUE(std::vector<unsigned>)
VOXC_OPTION_VALUE(std::vector<float>)
VOXC_OPTION_VALUE(std::vector<double>)
VOXC_OPTION_VALUE(std::optional<std::string>)
VOXC_OPTION_VALUE(std::optional<float>)
VOXC_OPTION_VALUE(std::optional<std::uint64_t>)
VOXC_OPTION_VALUE(std::optional<double>)
#undef VOXC_OPTION_VALUE

} // namespace voxc::tool
