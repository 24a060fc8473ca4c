// Formats whose references count granules, and volumes of them, as large as one likes.
#pragma once

#include "Construct/WholeBuild.h"
#include "testing/HardScenes.h"
#include "voxc/Support/WorkingMemory.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::test {

/// Every kind of level, slots and skips, apart and below each other.
inline constexpr const char *kFormats[] = {
    "format { level 1: raw(4, 4, 4) }",
    "format { level 1: raw(2, 3, 1) level 2: raw(1, 1, 1) }",
    "format { level 1: raw(0, 1, 0) level 2: svdag(3) }",
    "format { level 1: distance(2, 2, 2, 6) level 2: distance(2, 2, 2, 5) }",
    "format { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: masked(2, 2, 2) }",
    "format { level 1: svo(4) }",
    "format { level 1: svo(0) level 2: svo(2) level 3: raw(1, 1, 1) }",
    "format { level 1: svdag(4) }",
    "format { level 1: svdag(0) level 2: svdag(4, 2) dedup=level leaves=in-slot }",
    "format { level 1: svdag(2) level 2: hash(2, 2, 2) share=level }",
    "format { level 1: masked(1, 2, 1) level 2: masked(2, 2, 2) share=level }",
    "format { level 1: masked(3, 3, 3) level 2: hash(1, 1, 1) }",
    "format payload=occupancy { level 1: hash(1, 1, 1) level 2: svdag(3) }",
    "format payload=occupancy { level 1: raw(1, 1, 1) level 2: masked(1, 1, 1) level 3: masked(2, 2, 2) }",
    "format values=apart { level 1: distance(1, 1, 1, 4) level 2: svdag(3) dedup=level }",
    "format values=apart { level 1: raw(1, 1, 1) level 2: masked(1, 1, 1) share=level level 3: masked(2, 2, "
    "2) }",
    "format values=apart { level 1: svdag(2) level 2: masked(2, 2, 2) share=level }",
};

inline Format withGranule(Format format, std::string_view words) {
  format.setAttribute(kGranuleAttribute, words);
  return format;
}

inline bool isValid(const Format &format) {
  Diagnostics diagnostics;
  verify(format, diagnostics);
  return !diagnostics.hasErrors();
}

inline std::vector<Format> formatsWith(std::string_view words) {
  std::vector<Format> formats;
  for (const char *text : kFormats)
    if (const Format format = withGranule(*parseFormat(text), words); isValid(format))
      formats.push_back(format);
  return formats;
}

/// Nothing of it is taken but what is written to.
inline std::shared_ptr<WorkingMemory> vastMemory() { return WorkingMemory::create(std::uint64_t{1} << 42); }

/// A volume whose first node lies behind so many empty words.
inline Expected<Volume> build(const Format &format, const HardScene &scene, std::uint64_t emptyWords = 0,
                              const std::string &path = {}) {
  const auto construction = ConstructionOfFormat::compile(format);
  if (!construction)
    return construction.error();
  const BuildOptions options = {.memory = vastMemory(), .path = path};
  auto built = buildWhole(*scene.source(), *construction, options, emptyWords);
  if (!built)
    return built.error();
  return std::move(built->volume);
}

inline HardScene sceneOf(const Format &format, std::size_t number) {
  const auto scenes = hardScenes(format.extent());
  return scenes[number % scenes.size()];
}

} // namespace voxc::test
