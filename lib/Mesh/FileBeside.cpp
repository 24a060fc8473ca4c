// Spellings of a file's name, and the search for each.
#include "Mesh/FileBeside.h"

#include "Support/Text.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace voxc {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNameBlanks = " \t";

/// Entries of a folder that are looked at for a name in letters of another case.
constexpr int kMostListed = 1 << 16;

/// Ends of a path that are looked for.
constexpr std::size_t kMostParts = 8;

bool isFile(const std::string &path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string withSlashes(std::string_view name) {
  std::string path(name);
  std::ranges::replace(path, '\\', '/');
  return path;
}

std::string_view withoutQuotes(std::string_view name) {
  const bool isQuoted =
      name.size() >= 2 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
  return isQuoted ? name.substr(1, name.size() - 2) : name;
}

/// Backslashes before blanks mean nothing by themselves.
std::string withoutEscapes(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] != '\\' || i + 1 == name.size() || kNameBlanks.find(name[i + 1]) == std::string_view::npos)
      plain += name[i];
  return plain;
}

int hexOf(char c) {
  const std::size_t digit = std::string_view("0123456789abcdef").find(lowerCase({&c, 1}));
  return digit == std::string_view::npos ? -1 : static_cast<int>(digit);
}

/// As in addresses: "%20" is a blank.
std::string withoutPercents(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool isCode =
        name[i] == '%' && i + 2 < name.size() && hexOf(name[i + 1]) >= 0 && hexOf(name[i + 2]) >= 0;
    plain += isCode ? static_cast<char>(16 * hexOf(name[i + 1]) + hexOf(name[i + 2])) : name[i];
    i += isCode ? 2 : 0;
  }
  return plain;
}

/// What a name may mean, the likeliest first.
std::vector<std::string> spellingsOf(std::string_view name) {
  const std::string_view whole = withoutQuotes(trimmed(name));
  std::vector<std::string> spellings{withSlashes(whole), withSlashes(withoutEscapes(whole)),
                                     withSlashes(withoutPercents(whole))};
  // Before a comment, or options that stand behind the name.
  for (const std::string_view mark : {" #", " -"})
    if (const std::size_t end = whole.find(mark); end != std::string_view::npos)
      spellings.push_back(withSlashes(withoutQuotes(trimmed(whole.substr(0, end)))));
  return spellings;
}

/// Takes the first folder off all names that have one; false if none has.
bool shorten(std::vector<std::string> &names) {
  bool hasFolder = false;
  for (std::string &name : names) {
    const std::size_t slash = name.find('/');
    hasFolder = hasFolder || slash != std::string::npos;
    name.erase(0, slash == std::string::npos ? 0 : slash + 1);
  }
  return hasFolder;
}

/// Leaves of a path the last parts alone.
void keepLast(std::string &path, std::size_t parts) {
  std::size_t slash = path.size();
  for (std::size_t i = 0; i < parts && slash != std::string::npos && slash != 0; ++i)
    slash = path.rfind('/', slash - 1);
  if (slash != std::string::npos && slash != 0)
    path.erase(0, slash + 1);
}

} // namespace

std::string pathBelow(const std::string &folder, std::string_view name) {
  const std::string path = withSlashes(name);
  const bool hasDrive = path.size() > 2 && path[1] == ':' && path[2] == '/';
  return path.starts_with('/') || hasDrive ? path : folder + path;
}

/// Nothing if the folder has no such entry.
std::optional<std::string> FilesBeside::entryOf(const std::string &folder, const std::string &name) {
  const auto [listing, isNew] = listings_.try_emplace(folder);
  std::error_code failed;
  fs::directory_iterator entry;
  if (isNew)
    entry = fs::directory_iterator(folder.empty() ? "." : folder, failed);
  for (int i = 0; i < kMostListed && !failed && entry != fs::directory_iterator(); ++i) {
    const std::string found = entry->path().filename().string();
    listing->second.try_emplace(lowerCase(found), found);
    entry.increment(failed);
  }
  const auto found = listing->second.find(lowerCase(name));
  return found == listing->second.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> FilesBeside::inAnyCase(const std::string &folder, std::string_view path) {
  std::string found = folder;
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string part(path.substr(0, slash));
    path.remove_prefix(std::min(slash + 1, path.size()));
    std::error_code ignored;
    if (part.empty() || part == "." || part == ".." || fs::exists(found + part, ignored)) {
      found += part;
    } else {
      const auto entry = entryOf(found, part);
      if (!entry)
        return std::nullopt;
      found += *entry;
    }
    found += path.empty() ? "" : "/";
  }
  return isFile(found) ? std::optional(found) : std::nullopt;
}

std::optional<std::string> FilesBeside::findIn(std::span<const std::string> folders,
                                               const std::vector<std::string> &names) {
  for (const std::string &folder : folders)
    for (const std::string &name : names)
      if (std::string path = pathBelow(folder, name); isFile(path))
        return path;
  for (const std::string &folder : folders)
    for (const std::string &name : names)
      if (!name.starts_with('/'))
        if (const auto path = inAnyCase(folder, name))
          return path;
  return std::nullopt;
}

std::optional<FileBeside> FilesBeside::find(std::string_view name, std::span<const std::string> folders) {
  std::vector<std::string> names = spellingsOf(name);
  if (auto path = findIn(folders, names))
    return FileBeside{std::move(*path), false};
  for (std::string &spelling : names)
    keepLast(spelling, kMostParts);
  while (shorten(names))
    if (auto path = findIn(folders, names))
      return FileBeside{std::move(*path), true};
  // Downloads often have a folder of textures.
  std::vector<std::string> others;
  for (const std::string &folder : folders)
    for (const char *other : {"textures/", "../textures/"})
      others.push_back(folder + other);
  if (auto path = findIn(others, names))
    return FileBeside{std::move(*path), true};
  return std::nullopt;
}

std::string_view takeName(std::string_view &text) {
  text = trimmed(text);
  std::size_t end = 0;
  if (text.starts_with('"')) {
    end = std::min(text.find('"', 1), text.size() - 1) + 1;
  } else {
    while (end < text.size() && kNameBlanks.find(text[end]) == std::string_view::npos)
      end += text[end] == '\\' && end + 1 < text.size() ? 2 : 1;
    end = std::min(end, text.size());
  }
  const std::string_view name = text.substr(0, end);
  text.remove_prefix(end);
  return name;
}

} // namespace voxc
