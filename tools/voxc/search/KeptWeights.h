// What searches have learned of devices, kept for the next one: a file of the user's cache.
#pragma once

#include "voxc/Search/SpeedModel.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// The model of the device whose name contains `name` (any case) on this machine's processor, as the last
/// search there left it; else the default one. A file that is broken is as good as none.
SpeedModel speedModelFor(std::string_view name);

/// Keeps a model for a device of this full name. Without a folder for a cache, nothing is kept. Error:
/// `Environment`.
Expected<void> keepSpeedModel(const std::string &device, const SpeedModel &model);

} // namespace voxc::tool
