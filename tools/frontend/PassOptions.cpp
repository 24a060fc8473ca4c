// Pass flags, generated from the registry.
#include "frontend/PassOptions.h"

#include "common/Command.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace voxc::tool {

namespace {

constexpr const char *kPipelineOption = "--passes";
constexpr const char *kPointersOfInput = "short-pointers=auto";

const char *groupOf(PassChoice choice) {
  return choice == PassChoice::Pipeline ? "Passes, in the order written" : "Passes, in any order";
}

bool offered(const Pass &pass, PassChoice choice) {
  return choice != PassChoice::TraversalOnly || pass.effect == AttributeEffect::Traversal;
}

std::string flagOf(const Pass &pass) { return "--" + std::string(pass.name); }

bool isOfInput(const Pass &pass) { return std::string_view(kPointersOfInput).starts_with(pass.name); }

std::string helpOf(const Pass &pass, PassChoice choice) {
  std::string summary(pass.summary);
  if (!pass.number)
    return summary;
  return summary + "; =N is " + std::to_string(pass.number->least) + " to " +
         std::to_string(pass.number->most) + ", or " + std::to_string(pass.number->byDefault) +
         (choice == PassChoice::OfInput && isOfInput(pass) ? "; =auto, the fewest that do for the input"
                                                           : "");
}

/// A flag as written for the time `count`, from 0 on. What was given to it stays, also where it means
/// nothing: `runPasses` refuses it.
std::string writtenName(const Option &flag, std::size_t count) {
  const std::string name = flag.name().substr(2);
  const std::vector<std::string> written = flag.written();
  const std::string value = count < written.size() ? written[count] : "true";
  return value == "true" ? name : name + "=" + value;
}

/// The flag of a pass; one that had another name says so.
void declareFlag(const CommandLine &command, const Pass &pass, PassChoice choice) {
  command.addFlag(flagOf(pass), helpOf(pass, choice));
  constexpr std::string_view kTraversal = "-traversal";
  if (pass.name.ends_with(kTraversal))
    command.addFormer("--" + std::string(pass.name.substr(0, pass.name.size() - kTraversal.size())) + "-walk",
                      flagOf(pass));
}

} // namespace

void PassOptions::declare(const CommandLine &command, PassChoice choice) {
  command_ = command;
  const OptionGroup group(command, groupOf(choice));
  choice_ = choice;
  for (const Pass &pass : passes())
    if (offered(pass, choice))
      declareFlag(command, pass, choice);
  command
      .add(kPipelineOption, choice == PassChoice::Pipeline ? "The same as their flags, in this order"
                                                           : "The same as their flags")
      .list()
      .takes("A,B");
}

std::vector<std::string> PassOptions::names() const {
  std::vector<std::string> names;
  std::map<std::string, std::size_t> counts;
  for (const Option &option : command_->given()) {
    const std::vector<std::string> written = option.written();
    if (option.name() == kPipelineOption)
      names.insert(names.end(), written.begin(), written.end());
    else if (option.group() == groupOf(choice_))
      names.push_back(writtenName(option, counts[option.name()]++));
  }
  return names;
}

bool PassOptions::asksPointerBits() const {
  const std::vector<std::string> chosen = names();
  return choice_ == PassChoice::OfInput && std::ranges::find(chosen, kPointersOfInput) != chosen.end();
}

std::vector<std::string> PassOptions::namesWith(std::optional<int> pointerBits) const {
  std::vector<std::string> chosen = names();
  if (!asksPointerBits())
    return chosen;
  if (!pointerBits)
    std::erase(chosen, kPointersOfInput);
  else
    std::ranges::replace(chosen, kPointersOfInput, "short-pointers=" + std::to_string(*pointerBits));
  return chosen;
}

Expected<void> PassOptions::apply(Format &format, const PipelineOptions &options) const {
  const std::vector<std::string> chosen = namesWith(findPass("short-pointers")->number->byDefault);
  for (const std::string &name : chosen)
    if (const Pass *pass = findPass(name); pass && !offered(*pass, choice_))
      return Error::usage("pass '" + name +
                          "' changes what a volume stores; give it to 'voxc build' instead");
  return runPasses(format, chosen, options);
}

PipelineOptions tellingMissed(bool quiet) {
  PipelineOptions options;
  if (!quiet)
    options.afterEach = [](const PassReport &report, PrintedIr) {
      if (!report.changed)
        printNote("note: --" + std::string(report.pass) + " changes nothing: " + report.why);
    };
  return options;
}

} // namespace voxc::tool
