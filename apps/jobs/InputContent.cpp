// The content of an input, with the files that it refers to.
#include "jobs/InputContent.h"

#include "common/Interrupt.h"
#include "options/InputArguments.h"
#include "voxc/Input/NumberedPaths.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace voxc::tool {
namespace {

namespace fs = std::filesystem;

/// Inputs whose path may be a pattern of numbered files, and the most of these.
constexpr std::array<std::string_view, 4> kNumbered = {".png", ".vox", ".tif", ".tiff"};
constexpr std::size_t kMostNumbered = std::size_t{1} << 21;

/// Whether the ending of a path, in lower case, is one of these.
bool endsWith(const fs::path &path, std::span<const std::string_view> endings) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(endings, ending) != endings.end();
}

bool isPrefixed(const std::string &input) { return input.starts_with("grid:") || input.starts_with("raw:"); }

/// Where the path does not say it all: the size of a grid, and the ending that tells the kind, with a frame's
/// number.
std::string kindOf(const std::string &input) {
  return isPrefixed(input) ? input.substr(0, input.rfind(':')) : fs::path(input).extension().string();
}

/// What the content of an input names. Nothing but its own reader knows that, so it is opened, at the least
/// cost. What cannot be read names nothing: whoever builds it will say why. Error: `Interrupted`.
Expected<std::vector<std::string>> filesNamedBy(const std::string &input) {
  constexpr int kMostSide = 1 << kMaxLog2Extent;
  InputArguments coarsest;
  coarsest.resolution = 1;
  coarsest.isAutomatic = false;
  InputOptions options = makeInputOptions(coarsest, {kMostSide, kMostSide, kMostSide});
  options.progress.stop = &catchInterrupts();
  if (!mayHaveSeveralFiles(input, options))
    return std::vector<std::string>();
  auto opened = openInput(input, options);
  if (!opened && opened.error().kind == ErrorKind::Interrupted)
    return opened.error();
  return opened ? std::move(opened->files) : std::vector<std::string>();
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

Expected<std::vector<ContentFile>> contentFiles(const std::string &input,
                                                std::span<const std::string> named) {
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
  std::error_code ignored;
  if (const std::string journal = journalPathOf(path); fs::exists(journal, ignored))
    content.push_back({"journal", journal}); // Its edits are of what a volume holds.
  // By their names first, which stay the same where a folder is moved; each once.
  std::set<std::pair<std::string, std::string>> others;
  for (const std::string &other : named)
    others.emplace(fs::path(other).filename().string(), fs::absolute(other).lexically_normal().string());
  for (const auto &[name, other] : others)
    content.push_back({name, other});
  return content;
}

Expected<std::string> contentDigest(const std::string &input) {
  measure::Digest digest;
  if (input.starts_with("builtin:"))
    return digest.add(input).hex();
  const auto named = VOXC_TRY(filesNamedBy(input));
  const auto files = VOXC_TRY(contentFiles(input, named));
  for (const ContentFile &file : files) {
    digest.add(file.name);
    VOXC_TRY(digest.addFile(file.path));
  }
  return digest.hex();
}

} // namespace voxc::tool
