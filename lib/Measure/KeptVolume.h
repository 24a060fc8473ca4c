// Volumes that a search has built and keeps, with the figures of their builds beside them.
#pragma once

#include "voxc/Construct/Constructor.h"
#include "voxc/IR/Format.h"
#include "voxc/Measure/Record.h"
#include "voxc/Volume/Volume.h"

#include <optional>
#include <string>

namespace voxc::measure {

/// What a name of a volume ends with, and those of its format and of the figures of its build.
inline constexpr const char *kVolumeEnding = ".hvx", *kFormatEnding = ".vir", *kFiguresEnding = ".json";

/// A volume that was built before at `path`, whose build is told to the record; none if there is none, or one
/// of both is broken.
std::optional<Volume> loadKept(const std::string &path, Record &record);

/// Keeps what there is to tell of a build beside the volume at `path`, with the keys of `voxc build --stats`,
/// and tells it to the record. Error: `Environment`.
Expected<void> keepBuild(const std::string &path, const Format &storage, const Built &built,
                         double compileSeconds, Record &record);

} // namespace voxc::measure
