// What someone may have meant.
#include "Misspelling.h"

#include <algorithm>
#include <vector>

namespace voxc::tool {

namespace {

/// The options of a command as they are written: "--size".
std::vector<std::string> optionsOf(const CommandLine &command) {
  std::vector<std::string> names;
  for (const Option &option : command.options())
    for (const std::string &name : option.names())
      if (name.starts_with("--"))
        names.push_back(name);
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

/// The commands of `program` that have an option: "build, run".
std::string commandsWith(const CommandLine &program, const std::string &option) {
  std::string names;
  for (const CommandLine &command : program.commands())
    if (std::ranges::count(optionsOf(command), option) > 0)
      names += (names.empty() ? "" : ", ") + command.name();
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

std::string helpOf(const CommandLine &program, const CommandLine &command) {
  return program.name() + (command.parent() ? " " + command.name() : "") + " --help";
}

std::string explainUnknown(const CommandLine &program, const CommandLine &command, const std::string &word) {
  const std::string name = command.name();
  if (!word.starts_with('-'))
    return "'" + word + "' is one argument too many for " + name + "; see '" + helpOf(program, command) + "'";
  const std::string option = word.substr(0, word.find('='));
  std::string text = name + " has no option " + option;
  if (const std::string like = nearest(optionsOf(command), option); !like.empty())
    return text + "; did you mean " + like + "?";
  if (const std::string others = commandsWith(program, option); !others.empty())
    return text + "; these commands have it: " + others;
  return text + "; see '" + helpOf(program, command) + "'";
}

} // namespace voxc::tool
