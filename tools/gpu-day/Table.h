// All figures of a day: as one JSON, as records that `voxc bench report` reads, and as a table to print.
#pragma once

#include "voxc/Support/Error.h"

#include <string>

namespace voxc::gpu {

/// Reads the figures below `folder`: cells/*.json, as `measure` wrote them, lattice/*.json of `lattice`, and
/// of those that failed *.failed with a sentence. Writes gpu-day.json, results.jsonl and table.md to
/// `output`. Errors: a file that is none of these (`Input`), or that cannot be written (`Environment`).
Expected<void> writeTables(const std::string &folder, const std::string &output);

} // namespace voxc::gpu
