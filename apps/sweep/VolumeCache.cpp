// Building volumes and finding them again.
#include "sweep/VolumeCache.h"

#include "jobs/Child.h"

#include "common/Files.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace voxc::tool::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char *kVolumeEnding = ".hvx", *kFormatEnding = ".vir", *kFiguresEnding = ".json";

/// The figures beside a volume, which are written after it: with them it is complete.
std::optional<Json> readFigures(const std::string &path) {
  const Expected<std::string> text = readTextFile(path);
  if (!text)
    return std::nullopt;
  Json figures = Json::parse(*text, nullptr, false);
  return figures.is_object() ? std::optional(std::move(figures)) : std::nullopt;
}

/// The largest size so far of a file that is written under a temporary name beginning with `stem`.
class GrowingFile {
public:
  GrowingFile(fs::path folder, std::string stem) : folder_(std::move(folder)), stem_(std::move(stem)) {}

  void look() {
    std::error_code failure;
    for (fs::directory_iterator entry(folder_, failure), end; !failure && entry != end;
         entry.increment(failure))
      if (entry->path().filename().string().starts_with(stem_))
        if (const auto size = entry->file_size(failure); !failure)
          bytes_ = std::max<std::uint64_t>(bytes_, size);
  }
  std::uint64_t words() const { return bytes_ / sizeof(std::uint32_t); }
  /// Removes what a process that was killed left behind.
  void remove() const {
    std::error_code failure;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(folder_, failure), end; !failure && entry != end;
         entry.increment(failure))
      if (entry->path().filename().string().starts_with(stem_))
        left.push_back(entry->path());
    for (const fs::path &path : left)
      fs::remove(path, failure);
  }

private:
  fs::path folder_;
  std::string stem_;
  std::uint64_t bytes_ = 0;
};

Count wordsIn(const std::optional<Json> &figures) {
  if (!figures || !figures->contains("words") || !(*figures)["words"].is_number_unsigned())
    return std::nullopt;
  return (*figures)["words"].get<std::uint64_t>();
}

} // namespace

Expected<VolumeCache::Outcome> VolumeCache::get(const Model &model, const Format &format,
                                                const Progress &progress,
                                                const std::function<void()> &poll) const {
  const std::string storage = printIr(storageFormat(format));
  const std::string key = Digest().add(model.digest).add(storage).hex();
  const std::string stem = (fs::path(folder_) / key).string();
  std::error_code ignored;
  auto figures = readFigures(stem + kFiguresEnding);
  const Count words = wordsIn(figures);
  if (!words || !fs::exists(stem + kVolumeEnding, ignored)) {
    VOXC_TRY(writeText(stem + kFormatEnding, storage));
    return build(model, key, progress, poll);
  }
  if (*words > maxWords())
    return Outcome(Failure{"build",
                           "the volume has " + std::to_string(*words) + " words, more than the " +
                               std::to_string(maxWords()) + " that it may have",
                           words});
  return Outcome(CachedVolume{stem + kVolumeEnding, std::move(*figures)});
}

Expected<VolumeCache::Outcome> VolumeCache::build(const Model &model, const std::string &key,
                                                  const Progress &progress,
                                                  const std::function<void()> &poll) const {
  const std::string stem = (fs::path(folder_) / key).string();
  const std::string volume = stem + kVolumeEnding, figuresFile = stem + kFiguresEnding;
  std::vector<std::string> arguments{"build",
                                     stem + kFormatEnding,
                                     model.input,
                                     "-o",
                                     volume,
                                     "--stats",
                                     figuresFile,
                                     "--quiet",
                                     "--max-bytes=" + std::to_string(means_.maxBytes)};
  for (const auto &words : {toWords(model.arguments), means_.options})
    arguments.insert(arguments.end(), words.begin(), words.end());
  std::error_code ignored;
  fs::remove(figuresFile, ignored);
  GrowingFile growing(folder_, key + kVolumeEnding + ".");
  const auto child = runChild(arguments, progress, [&] {
    growing.look();
    poll();
  });
  auto figures = readFigures(figuresFile);
  if (child && child->succeeded && figures)
    return Outcome(CachedVolume{volume, std::move(*figures)});
  growing.remove();
  fs::remove(figuresFile, ignored);
  if (!child)
    return child.error();
  const Count words = wordsIn(figures);
  return Outcome(Failure{"build", child->succeeded ? "the build left no figures" : child->failure,
                         words ? words : Count(growing.words())});
}

} // namespace voxc::tool::bench
