// Runtime files as text.
#include "RuntimeText.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr std::string_view kInclude = "#include \"";
constexpr std::string_view kCapitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

/// The paths that a text includes.
std::vector<std::string_view> includesOf(std::string_view text) {
  std::vector<std::string_view> paths;
  for (std::size_t at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at)) {
    at += kInclude.size();
    paths.push_back(text.substr(at, text.find('"', at) - at));
  }
  return paths;
}

} // namespace

std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path) {
  const auto file = std::ranges::find(files, path, &EmbeddedFile::path);
  return file == files.end() ? "#error a runtime file is missing\n" : file->text;
}

std::vector<EmbeddedFile> includedBy(const std::set<std::string_view> &paths,
                                     std::span<const EmbeddedFile> files) {
  std::set<std::string_view> found;
  std::vector<std::string_view> open(paths.begin(), paths.end());
  while (!open.empty()) {
    const std::string_view path = open.back();
    open.pop_back();
    const auto file = std::ranges::find(files, path, &EmbeddedFile::path);
    if (file == files.end() || !found.insert(path).second)
      continue;
    const auto further = includesOf(file->text);
    open.insert(open.end(), further.begin(), further.end());
  }
  std::vector<EmbeddedFile> included;
  std::ranges::copy_if(files, std::back_inserter(included),
                       [&](const EmbeddedFile &file) { return found.contains(file.path); });
  return included;
}

std::vector<EmbeddedFile> constructHeadersOf(std::string_view text) {
  const auto paths = includesOf(text);
  return includedBy({paths.begin(), paths.end()}, constructHeaders());
}

std::set<std::string, std::less<>> namesBehind(std::string_view prefix, std::string_view text) {
  std::set<std::string, std::less<>> names;
  for (std::size_t at = text.find(prefix); at != std::string_view::npos; at = text.find(prefix, at)) {
    at += prefix.size();
    const std::size_t end = std::min(text.find_first_not_of(kCapitals, at), text.size());
    const bool isName = end > at && (end == text.size() || !(text[end] >= 'a' && text[end] <= 'z'));
    if (isName)
      names.emplace(text.substr(at, end - at));
  }
  return names;
}

} // namespace voxc
