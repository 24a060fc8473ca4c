// The content of an input, with the files that it refers to.
#include "jobs/InputContent.h"

#include "voxc/Input/NumberedPaths.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Support/File.h"
#include "voxc/Support/NumberedPath.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string_view>

namespace voxc::tool {
namespace {

namespace fs = std::filesystem;

/// Inputs whose text names other files, and those among the others whose text does.
constexpr std::array<std::string_view, 4> kReferring = {".obj", ".gltf", ".nhdr", ".mtl"};
constexpr std::size_t kMostCompanions = 10000;
constexpr int kDeepest = 4;

/// Inputs whose path may be a pattern of numbered files, and the most of these.
constexpr std::array<std::string_view, 4> kNumbered = {".png", ".vox", ".tif", ".tiff"};
constexpr std::size_t kMostNumbered = std::size_t{1} << 21;

/// Whether the ending of a path, in lower case, is one of these.
bool endsWith(const fs::path &path, std::span<const std::string_view> endings) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(endings, ending) != endings.end();
}

bool refers(const fs::path &path) { return endsWith(path, kReferring); }

/// The files of a folder and of those below it, by path so that their order is always the same.
std::map<std::string, bool> filesBelow(const fs::path &folder) {
  std::map<std::string, bool> files;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure), end;
  for (; !failure && entry != end && files.size() < kMostCompanions; entry.increment(failure)) {
    if (entry.depth() >= kDeepest)
      entry.disable_recursion_pending();
    std::error_code ignored;
    if (entry->is_regular_file(ignored))
      files.emplace(entry->path().string(), false);
  }
  return files;
}

/// Whether a text has a pattern, such as slice%03d.raw, that a file's name is one of.
bool namesByPattern(const std::string &text, const std::string &name) {
  for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%', at + 1)) {
    const std::size_t begin = text.find_last_of(" \t\n/", at) + 1;
    const auto pattern = NumberedPath::parse(text.substr(begin, text.find_first_of(" \t\r\n", at) - begin));
    if (!pattern || !name.starts_with(pattern->before()) || !name.ends_with(pattern->after()) ||
        name.size() <= pattern->before().size() + pattern->after().size())
      continue;
    const std::size_t digits = name.size() - pattern->before().size() - pattern->after().size();
    if (name.find_first_not_of("0123456789", pattern->before().size()) >= pattern->before().size() + digits)
      return true;
  }
  return false;
}

/// The other files of a pair, header and samples, that are there.
std::vector<std::string> partnersOf(const std::string &path) {
  constexpr std::array<std::string_view, 4> kPair{".hdr", ".img", ".hdr.gz", ".img.gz"};
  std::vector<std::string> partners;
  for (const std::string_view own : kPair)
    for (const std::string_view other : kPair) {
      const std::string stem = path.ends_with(own) ? path.substr(0, path.size() - own.size()) : "";
      std::error_code ignored;
      if (!stem.empty() && own != other && fs::exists(stem + std::string(other), ignored))
        partners.push_back(stem + std::string(other));
    }
  return partners;
}

/// Lists what `path` names among the files that were not listed yet, and what these name.
Expected<void> addCompanions(const std::string &path, std::map<std::string, bool> &files,
                             std::vector<ContentFile> &content) {
  const auto text = VOXC_TRY(readTextFile(path));
  for (auto &[companion, added] : files) {
    const std::string name = fs::path(companion).filename().string();
    if (added || (text.find(name) == std::string::npos && !namesByPattern(text, name)))
      continue;
    added = true;
    content.push_back({name, companion});
    if (refers(companion))
      VOXC_TRY(addCompanions(companion, files, content));
  }
  return {};
}

bool isPrefixed(const std::string &input) { return input.starts_with("grid:") || input.starts_with("raw:"); }

/// Where the path does not say it all: the size of a grid, and the ending that tells the kind, with a frame's
/// number.
std::string kindOf(const std::string &input) {
  return isPrefixed(input) ? input.substr(0, input.rfind(':')) : fs::path(input).extension().string();
}

} // namespace

std::string fileOf(const std::string &input) {
  if (isPrefixed(input))
    return input.substr(input.rfind(':') + 1);
  // The number of a frame: scene.vox#3.
  const std::size_t mark = input.rfind('#');
  const bool isFrame = mark != std::string::npos && mark + 1 < input.size() &&
                       input.find_first_not_of("0123456789", mark + 1) == std::string::npos;
  return isFrame ? input.substr(0, mark) : input;
}

Expected<std::vector<ContentFile>> contentFiles(const std::string &input) {
  std::vector<ContentFile> content;
  if (input.starts_with("builtin:"))
    return content;
  const std::string path = fileOf(input);
  if (!isPrefixed(input) && endsWith(path, kNumbered)) {
    const auto paths = VOXC_TRY(numberedPaths(path, kMostNumbered));
    for (const std::string &numbered : paths)
      content.push_back({kindOf(input), numbered});
    return content;
  }
  content.push_back({kindOf(input), path});
  for (const std::string &partner : partnersOf(path))
    content.push_back({fs::path(partner).extension().string(), partner});
  std::error_code ignored;
  if (const std::string journal = journalPathOf(path); fs::exists(journal, ignored))
    content.push_back({"journal", journal}); // Its edits are of what a volume holds.
  if (refers(path)) {
    const fs::path folder = fs::path(path).parent_path();
    auto files = filesBelow(folder.empty() ? "." : folder);
    files[path] = true;
    VOXC_TRY(addCompanions(path, files, content));
  }
  return content;
}

Expected<std::string> contentDigest(const std::string &input) {
  measure::Digest digest;
  if (input.starts_with("builtin:"))
    return digest.add(input).hex();
  const auto files = VOXC_TRY(contentFiles(input));
  for (const ContentFile &file : files) {
    digest.add(file.name);
    VOXC_TRY(digest.addFile(file.path));
  }
  return digest.hex();
}

} // namespace voxc::tool
