// Pass flags, generated from the registry.
#include "frontend/PassOptions.h"

#include <CLI/CLI.hpp>

namespace voxc::tool {

namespace {

constexpr const char *kGroup = "Passes, in the order written";
constexpr const char *kPipelineOption = "--passes";

bool offered(const Pass &pass, PassChoice choice) {
  return choice == PassChoice::All || pass.effect == AttributeEffect::Walk;
}

std::string flagOf(const Pass &pass) { return "--" + std::string(pass.name); }

std::string helpOf(const Pass &pass) {
  const std::string summary(pass.summary);
  return pass.number ? summary + "; =N is " + std::to_string(pass.number->least) + " to " +
                           std::to_string(pass.number->most) + ", or " + std::to_string(pass.number->usual)
                     : summary;
}

/// A flag as it was written: one that was given a number, or several, has the last.
std::string writtenName(const CLI::Option &flag) {
  const std::string name = flag.get_name().substr(2);
  const Pass *const pass = findPass(name);
  const std::string value = flag.results().empty() ? "" : flag.results().back();
  return pass && pass->number && value != "true" ? name + "=" + value : name;
}

} // namespace

void PassOptions::declare(CLI::App &app, PassChoice choice) {
  app_ = &app;
  choice_ = choice;
  for (const Pass &pass : passes())
    if (offered(pass, choice))
      app.add_flag(flagOf(pass))->description(helpOf(pass))->group(kGroup);
  app.add_option(kPipelineOption, "The same as their flags, in this order")
      ->delimiter(',')
      ->type_name("A,B")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(kGroup);
}

std::vector<std::string> PassOptions::names() const {
  std::vector<std::string> names;
  for (const CLI::Option *option : app_->parse_order()) {
    const std::string name = option->get_name();
    if (name == kPipelineOption)
      names.insert(names.end(), option->results().begin(), option->results().end());
    else if (option->get_group() == kGroup)
      names.push_back(writtenName(*option));
  }
  return names;
}

Expected<void> PassOptions::apply(Format &format, const PipelineOptions &options) const {
  const std::vector<std::string> chosen = names();
  for (const std::string &name : chosen)
    if (const Pass *pass = findPass(name); pass && !offered(*pass, choice_))
      return Error::usage("pass '" + name +
                          "' changes what a volume stores; give it to 'voxc build' instead");
  return runPasses(format, chosen, options);
}

} // namespace voxc::tool
