// Volumes that a search has built and keeps, with the figures of their builds beside them.
#pragma once

#include "bench/Record.h"
#include "common/Json.h"
#include "voxc/Volume/Volume.h"

#include <optional>
#include <string>

namespace voxc::tool {

/// What a record tells of a volume, by the figures that are kept beside it.
void addVolume(const Json &figures, bench::Record &record);

/// A volume that was built before, and its figures; none if there is none, or one of both is broken.
std::optional<Volume> loadKept(const std::string &path, const std::string &figuresPath, Json &figures);

} // namespace voxc::tool
