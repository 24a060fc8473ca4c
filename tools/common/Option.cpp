// Options of CLI11.
#include "Option.h"

#include "Help.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <string_view>

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

/// For CLI11 NaN lies in all ranges.
std::string problemOfNan(const std::string &text) {
  double number = 0;
  const bool isNan = CLI::detail::lexical_cast(text, number) && std::isnan(number);
  return isNan ? "should be a number, not " + text : "";
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

// What numbers are in our programs.

template Option Option::between(int, int) const;
template Option Option::between(unsigned, unsigned) const;
template Option Option::between(std::uint64_t, std::uint64_t) const;
template Option Option::between(float, float) const;
template Option Option::between(double, double) const;

} // namespace voxc::tool
