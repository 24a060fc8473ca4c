// voxc completion: what a shell needs to complete commands, options and their values.
#include "help/CompletionTable.h"
#include "program/Subcommand.h"
#include "voxc/Support/EmbeddedFile.h"

#include <cstdio>
#include <span>
#include <vector>

namespace voxc {

/// completion.bash and its like (cmake/VoxcEmbed.cmake).
std::span<const EmbeddedFile> completionFiles();

} // namespace voxc

namespace voxc::tool {

namespace {

/// A text with one of its words replaced.
std::string replaced(std::string text, std::string_view word, std::string_view by) {
  return text.replace(text.find(word), word.size(), by);
}

/// The script that is completion.`shell`.
std::string scriptOf(std::string_view shell) {
  for (const EmbeddedFile &file : completionFiles())
    if (file.path.ends_with(shell))
      return std::string(file.text);
  return "";
}

/// For bash and zsh, where a quote ends the text, stands by itself, and begins it anew.
std::string quotedOfPosix(std::string text) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

/// All commands in quotes, with something between.
std::string pathsOf(const CompletionTable &table, std::string_view between) {
  std::string paths;
  for (const CompletionRow &row : table.rows)
    if (!row.path.empty())
      paths += (paths.empty() ? "" : std::string(between)) + "'" + row.path + "'";
  return paths;
}

/// A script of "case": lines for each option with values, and for each command, written as `begin` and `end`
/// say.
std::string caseText(const CompletionTable &table, std::string_view shell, std::string_view begin,
                     std::string_view end, std::string (*wordsOf)(const CompletionRow &row)) {
  std::string values, words;
  for (const auto &[name, text] : table.values)
    values.append(values.empty() ? "  " : "\n  ")
        .append(name)
        .append(") ")
        .append(begin)
        .append(text)
        .append(end);
  for (const CompletionRow &row : table.rows)
    words += (words.empty() ? "    '" : "\n    '") + row.path + "') " + std::string(begin) + wordsOf(row) +
             std::string(end);
  const std::string script = replaced(scriptOf(shell), "@COMMANDS@", pathsOf(table, " | "));
  return replaced(replaced(script, "@VALUES@", values), "@WORDS@", words);
}

/// Names with blanks between.
std::string namesOf(const CompletionRow &row) {
  std::string names;
  for (const CompletionWord &word : row.words)
    names += (names.empty() ? "" : " ") + word.name;
  return names;
}

/// 'name:what it is', as _describe takes them.
std::string describedNamesOf(const CompletionRow &row) {
  std::string names;
  for (const CompletionWord &word : row.words)
    names += (names.empty() ? "" : " ") + quotedOfPosix(word.name + ":" + word.summary);
  return names;
}

std::string bashText(const CompletionTable &table) {
  return caseText(table, "bash", "words='", "' ;;", namesOf);
}

std::string zshText(const CompletionTable &table) {
  return caseText(table, "zsh", "choices=(", ") ;;", describedNamesOf);
}

/// For fish, where a quote within quotes has a backslash before it.
std::string fishQuoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return result + "'";
}

/// "complete" for a word that may follow a command.
std::string fishLine(const CompletionTable &table, const std::string &path, const CompletionWord &word) {
  std::string line = "complete -c voxc -n '__voxc_at \"" + path + "\"'";
  if (!word.isOption())
    line += " -f -a " + word.name;
  else
    line += word.name.starts_with("--") ? " -l " + word.name.substr(2) : " -s " + word.name.substr(1);
  if (const auto values = table.values.find(word.name); values != table.values.end())
    line += " -x -a " + fishQuoted(values->second);
  else if (word.takesValue)
    line += " -r";
  return line + " -d " + fishQuoted(word.summary) + "\n";
}

std::string fishText(const CompletionTable &table) {
  std::string lines;
  for (const CompletionRow &row : table.rows)
    for (const CompletionWord &word : row.words)
      lines += fishLine(table, row.path, word);
  lines.pop_back();
  return replaced(replaced(scriptOf("fish"), "@COMMANDS@", pathsOf(table, " ")), "@WORDS@", lines);
}

struct Shell {
  const char *name;
  std::string (*text)(const CompletionTable &table);
};

constexpr Shell kShells[] = {{"bash", bashText}, {"zsh", zshText}, {"fish", fishText}};

class CompletionCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    program_ = command.parent();
    std::vector<std::string> names;
    for (const Shell &shell : kShells)
      names.emplace_back(shell.name);
    command.add("SHELL", shell_, "The shell: bash, zsh or fish").required().takes("").oneOf(names);
    addCommonOptions(command, common_);
    command.remove(command.option("--stats")); // A script has no figures.
  }

  Expected<void> run() override {
    for (const Shell &shell : kShells)
      if (shell_ == shell.name)
        std::fputs(shell.text(completionTable(*program_)).c_str(), stdout);
    return {};
  }

private:
  std::optional<CommandLine> program_;
  std::string shell_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeCompletionCommand() { return std::make_unique<CompletionCommand>(); }

} // namespace voxc::tool
