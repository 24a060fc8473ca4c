// What can stand where on a command line of voxc.
#include "help/CompletionTable.h"

namespace voxc::tool {

namespace {

/// The values that an option offers, or the names of its type "a|b=a", with blanks between.
std::string valuesOf(const Option &option) {
  if (const std::vector<std::string> choices = option.choices(); !choices.empty()) {
    std::string values;
    for (const std::string &choice : choices)
      values += (values.empty() ? "" : " ") + choice;
    return values;
  }
  const std::string type = option.value();
  std::string values = type.substr(0, type.find('='));
  if (values.find('|') == std::string::npos || values.find_first_of("[:,. ") != std::string::npos)
    return "";
  for (char &c : values)
    if (c == '|')
      c = ' ';
  return values;
}

bool isShown(const CommandLine &command) { return !command.group().empty(); }

void addOption(const Option &option, CompletionRow &row, CompletionTable &table) {
  const std::string values = valuesOf(option);
  for (const std::string &name : option.names()) {
    row.words.push_back({name, option.text(), option.takesValue()});
    if (!values.empty())
      table.values[name] = values;
  }
}

/// `all` has what was collected by path.
void collect(const CommandLine &command, const std::string &path, CompletionTable &table,
             std::map<std::string, CompletionRow> &all) {
  CompletionRow &row = all[path];
  row.path = path;
  for (const CommandLine &sub : command.commands())
    if (isShown(sub)) {
      row.words.push_back({sub.name(), sub.text()});
      collect(sub, path.empty() ? sub.name() : path + " " + sub.name(), table, all);
    }
  for (const Option &option : command.options())
    if (!option.isWord())
      addOption(option, row, table);
}

} // namespace

CompletionTable completionTable(const CommandLine &program) {
  CompletionTable table;
  std::map<std::string, CompletionRow> rows;
  collect(program, "", table, rows);
  for (auto &[path, row] : rows)
    table.rows.push_back(std::move(row));
  return table;
}

} // namespace voxc::tool
