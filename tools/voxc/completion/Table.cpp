// What can stand where on a command line of voxc.
#include "Table.h"

namespace voxc::tool {

namespace {

/// The names of an option's check "{a,b}" or of its type "a|b=a".
std::string valuesOf(const CLI::Option &option) {
  const std::string type = option.get_type_name();
  std::string values = type.substr(0, type.find('='));
  if (values.find('|') == values.npos || values.find_first_of("[:,. ") != values.npos)
    return "";
  for (char &c : values)
    if (c == '|')
      c = ' ';
  return values;
}

/// All names of an option, with its dashes.
std::vector<std::string> namesOf(const CLI::Option &option) {
  std::vector<std::string> names;
  for (const std::string &name : option.get_lnames())
    names.push_back("--" + name);
  for (const std::string &name : option.get_snames())
    names.push_back("-" + name);
  return names;
}

bool isShown(const CLI::App &command) { return !command.get_group().empty(); }

void addOption(const CLI::Option &option, CompletionRow &row, CompletionTable &table) {
  const std::string values = valuesOf(option);
  for (const std::string &name : namesOf(option)) {
    row.words.push_back({name, option.get_description(), option.get_type_size() > 0});
    if (!values.empty())
      table.values[name] = values;
  }
}

/// `all` has what was collected by path.
void collect(const CLI::App &command, const std::string &path, CompletionTable &table,
             std::map<std::string, CompletionRow> &all) {
  CompletionRow &row = all[path];
  row.path = path;
  for (const CLI::App *sub : command.get_subcommands({}))
    if (isShown(*sub)) {
      row.words.push_back({sub->get_name(), sub->get_description()});
      collect(*sub, path.empty() ? sub->get_name() : path + " " + sub->get_name(), table, all);
    }
  for (const CLI::Option *option : command.get_options())
    if (option->nonpositional())
      addOption(*option, row, table);
}

} // namespace

CompletionTable completionTable(const CLI::App &root) {
  CompletionTable table;
  std::map<std::string, CompletionRow> rows;
  collect(root, "", table, rows);
  for (auto &[path, row] : rows)
    table.rows.push_back(std::move(row));
  return table;
}

} // namespace voxc::tool
