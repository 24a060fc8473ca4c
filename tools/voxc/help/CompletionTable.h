// What can stand where on a command line of voxc, for shells: drawn from the commands themselves.
#pragma once

#include "common/CommandLine.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool {

/// A name that may follow a command.
struct CompletionWord {
  std::string name;        ///< "build", "--view" or "-o".
  std::string summary;     ///< What the help says of it.
  bool takesValue = false; ///< Of an option.
  bool isOption() const { return name.starts_with('-'); }
};

struct CompletionRow {
  std::string path; ///< "build", or "bench export": what the line begins with behind the tool's name.
  std::vector<CompletionWord> words;
};

struct CompletionTable {
  std::vector<CompletionRow> rows; ///< Sorted by path.
  /// By option: what can stand behind it, if that is known, with blanks between. Those of one name have the
  /// same values everywhere.
  std::map<std::string, std::string> values;
};

CompletionTable completionTable(const CommandLine &program);

} // namespace voxc::tool
