// Files that a model names, which often come from another machine.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct FileBeside {
  std::string path;
  bool isElsewhere = false; ///< It is not where the name says, but has the same last part.
};

/// Finds files, and remembers what the folders hold that it looked into.
class FilesBeside {
public:
  /// The file that `name` means, looked for in each of the folders (with a slash at their ends, or empty): as
  /// it is written; without quotes; with slashes for backslashes; with escaped blanks; without a comment or
  /// options behind it; in letters of another case; last of all by the ends of its path, down to its last
  /// part alone, as of a path of another machine, and that in a folder `textures`. Nothing if there is none.
  std::optional<FileBeside> find(std::string_view name, std::span<const std::string> folders);

private:
  std::optional<std::string> findIn(std::span<const std::string> folders,
                                    const std::vector<std::string> &names);
  std::optional<std::string> inAnyCase(const std::string &folder, std::string_view path);
  std::optional<std::string> entryOf(const std::string &folder, const std::string &name);

  /// Of each folder its entries by their names in lower case.
  std::map<std::string, std::map<std::string, std::string>> listings_;
};

/// Takes the next name off the front of `text`: one in quotes, or a word whose blanks may be escaped with
/// backslashes; empty if there is none.
std::string_view takeName(std::string_view &text);

/// The name with slashes for backslashes, below the folder unless it is absolute, here or on
/// Windows.
std::string pathBelow(const std::string &folder, std::string_view name);

} // namespace voxc
