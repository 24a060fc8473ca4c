// The handles on CLI11.
#include "CommandLine.h"

#include "Help.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>

namespace voxc::tool {
namespace {

/// Begins the name of a check that has choices, which stand behind it.
constexpr std::string_view kChoices = "choices: ";

std::string nameOfChoices(const std::vector<std::string> &values) {
  std::string name(kChoices);
  for (const std::string &value : values)
    name += (name.ends_with(' ') ? "" : " ") + value;
  return name;
}

} // namespace

Option Option::takes(const std::string &value) const {
  option_->type_name(value);
  return *this;
}

Option Option::text(const std::string &text) const {
  option_->description(text);
  return *this;
}

Option Option::required(bool isRequired) const {
  option_->required(isRequired);
  return *this;
}

Option Option::showsDefault() const {
  option_->capture_default_str();
  return *this;
}

Option Option::showsDefault(const std::string &value) const {
  option_->default_str(value);
  return *this;
}

// Checks describe themselves in the help of CLI11; ours says it in words.

Option Option::oneOf(const std::vector<std::string> &values) const {
  option_->check(CLI::IsMember(values).description("").name(nameOfChoices(values)));
  return *this;
}

Option Option::suggests(const std::vector<std::string> &values) const {
  const auto takesAll = [](std::string &) { return std::string(); };
  option_->check(CLI::Validator(takesAll, "", nameOfChoices(values)));
  return *this;
}

std::vector<std::string> Option::choices() const {
  try {
    for (int i = 0;; ++i)
      if (const std::string &name = option_->get_validator(i)->get_name(); name.starts_with(kChoices))
        return CLI::detail::split(name.substr(kChoices.size()), ' ');
  } catch (const CLI::OptionNotFound &) {
    return {}; // There are no more.
  }
}

namespace {

/// For CLI11 NaN lies in all ranges.
std::string problemOfNan(const std::string &text) {
  double number = 0;
  const bool isNan = CLI::detail::lexical_cast(text, number) && std::isnan(number);
  return isNan ? "should be a number, not " + text : "";
}

} // namespace

template <typename Number> Option Option::between(Number least, Number most) const {
  option_->check(problemOfNan);
  option_->check(CLI::Range(least, most).description(""));
  return *this;
}

Option Option::positive() const {
  option_->check(problemOfNan);
  option_->check(CLI::PositiveNumber.description(""));
  return *this;
}

Option Option::notNegative() const {
  option_->check(problemOfNan);
  option_->check(CLI::NonNegativeNumber.description(""));
  return *this;
}

Option Option::notEmpty() const {
  return check([](const std::string &value) -> std::string {
    return value.empty() ? "the name of the output is empty; name a file" : "";
  });
}

Option Option::check(std::string (*problemOf)(const std::string &value)) const {
  option_->check(CLI::Validator(problemOf, "", ""));
  return *this;
}

Option Option::list() const {
  option_->delimiter(',');
  return repeated(); // Or CLI11 would take the words behind it too, FORMAT for one.
}

Option Option::values(std::size_t count) const {
  // All of them are known when the first is checked.
  const auto problemOf = [option = option_, count](const std::string &) {
    const std::size_t given = option->results().size();
    return given == count ? std::string()
                          : "takes " + std::to_string(count) + " values with commas between them, not " +
                                std::to_string(given);
  };
  option_->check(CLI::Validator(problemOf, "", ""));
  return *this;
}

Option Option::repeated() const {
  option_->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return *this;
}

Option Option::lastCounts() const {
  option_->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(Option other) const {
  option_->excludes(other.option_);
  return *this;
}

std::string Option::name() const { return option_->get_name(); }
bool Option::isCalled(const std::string &name) const { return option_->check_name(name); }
std::string Option::text() const { return option_->get_description(); }
std::string Option::group() const { return option_->get_group(); }

std::vector<std::string> Option::names() const {
  std::vector<std::string> names;
  for (const std::string &name : option_->get_lnames())
    names.push_back("--" + name);
  for (const std::string &name : option_->get_snames())
    names.push_back("-" + name);
  return names;
}

std::string Option::value() const { return option_->get_type_name(); }
std::string Option::usage() const { return optionUsage(*option_); }
bool Option::isRequired() const { return option_->get_required(); }
bool Option::isWord() const { return option_->get_positional(); }
bool Option::takesValue() const { return option_->get_items_expected_max() > 0; }
std::size_t Option::count() const { return option_->count(); }
std::vector<std::string> Option::written() const { return option_->results(); }

std::vector<std::string> Option::words() const {
  if (count() == 0)
    return {};
  if (!takesValue())
    return {name()};
  const char delimiter = option_->get_delimiter();
  std::vector<std::string> words;
  for (const std::string &value : written())
    if (words.empty() || delimiter == '\0') {
      if (!isWord())
        words.push_back(name());
      words.push_back(value);
    } else {
      words.back() += delimiter + value;
    }
  return words;
}

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

template Option Option::between(int, int) const;
template Option Option::between(unsigned, unsigned) const;
template Option Option::between(std::uint64_t, std::uint64_t) const;
template Option Option::between(float, float) const;
template Option Option::between(double, double) const;

} // namespace voxc::tool
