// The volumes of a sweep, each built once and kept by what it is made of.
#pragma once

#include "sweep/Model.h"

#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Measure/Record.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

/// A volume in the cache.
struct CachedVolume {
  std::string path;
  Json figures; ///< Those of `voxc build --stats`.
};

/// How volumes are built, beside their format and model.
struct BuildMeans {
  std::uint64_t maxBytes = 0;       ///< Of a volume's words.
  std::vector<std::string> options; ///< Further options of `voxc build`: --memory, --scratch, --threads.
};

class VolumeCache {
public:
  /// `folder` is there already.
  VolumeCache(std::string folder, BuildMeans means) : folder_(std::move(folder)), means_(std::move(means)) {}

  /// A volume, or why there is none and how far it came.
  using Outcome = std::variant<CachedVolume, Failure>;

  /// The volume of a model in a format, built in a process of its own if it is not there: formats that differ
  /// in their traversal share it. A build that fails is an outcome. Errors: `Interrupted`; `Environment` if
  /// nothing can be written, or no process be made.
  Expected<Outcome> get(const Model &model, const Format &format, const Progress &progress,
                        const std::function<void()> &poll) const;

private:
  std::uint64_t maxWords() const { return means_.maxBytes / sizeof(std::uint32_t); }
  Expected<Outcome> build(const Model &model, const std::string &key, const Progress &progress,
                          const std::function<void()> &poll) const;

  std::string folder_;
  BuildMeans means_;
};

} // namespace voxc::tool::bench
