// What someone may have meant.
#include "Misspelling.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

namespace voxc::tool {

namespace {

/// The options of a command as they are written: "--size".
std::vector<std::string> optionsOf(const CLI::App &command) {
  std::vector<std::string> names;
  for (const CLI::Option *option : command.get_options())
    for (const std::string &name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

/// The option most like `word`, if it is like it at all.
std::string nearest(const std::vector<std::string> &names, std::string_view word) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 4) + 1;
  for (const std::string &name : names)
    if (const std::size_t distance = wordDistance(name, word); distance < least) {
      least = distance;
      best = name;
    }
  return best;
}

/// The commands of `app` that have an option: "build, run".
std::string commandsWith(const CLI::App &app, const std::string &option) {
  std::string names;
  for (const CLI::App *command : app.get_subcommands([](const CLI::App *) { return true; }))
    if (std::ranges::count(optionsOf(*command), option) > 0)
      names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

} // namespace

std::size_t wordDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

std::string helpOf(const CLI::App &app, const CLI::App &command) {
  return app.get_name() + (&app == &command ? "" : " " + command.get_name()) + " --help";
}

std::string explainUnknown(const CLI::App &app, const CLI::App &command, const std::string &word) {
  const std::string name = command.get_name();
  if (!word.starts_with('-'))
    return "'" + word + "' is one argument too many for " + name + "; see '" + helpOf(app, command) + "'";
  const std::string option = word.substr(0, word.find('='));
  std::string text = name + " has no option " + option;
  if (const std::string like = nearest(optionsOf(command), option); !like.empty())
    return text + "; did you mean " + like + "?";
  if (const std::string others = commandsWith(app, option); !others.empty())
    return text + "; these commands have it: " + others;
  return text + "; see '" + helpOf(app, command) + "'";
}

} // namespace voxc::tool
