// What searches have learned of devices, kept for the next one: a file of the user's cache.
#pragma once

#include "voxc/Search/SpeedModel.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>

namespace voxc::measure {

/// What is known of how fast a device is.
struct KnownSpeeds {
  SpeedModel model;
  bool isMeasured = false; ///< By a search with this device and processor; else it is of another machine.
};

/// How many times too fast or too slow a format was predicted, at worst, by another machine's model.
inline constexpr double kWorstUnmeasured = 1.8;

/// The model of the device whose name contains `name` (any case) on this machine's processor, as the last
/// search there left it; else the default one. A file that is broken is as good as none.
KnownSpeeds knownSpeedsOf(std::string_view name);

/// Whether speeds can be predicted of a device: "cpu", "llvmpipe", whose figures are the default, one that
/// was measured, or one that is there. Error (`Environment`): none of that name.
Expected<void> checkSpeedsKnown(const std::string &name);

/// Keeps a model for a device of this full name. Without a folder for a cache, nothing is kept. Error:
/// `Environment`.
Expected<void> keepSpeedModel(const std::string &device, const SpeedModel &model);

} // namespace voxc::measure
