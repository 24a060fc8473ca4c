// All figures of a day: as one JSON, as records that `voxc bench report` reads, and as a table to print.
#pragma once

#include "voxc/Support/Error.h"

#include <string>

namespace voxc::gpu {

/// Reads every *.json of `folder`, as `measure` wrote them, and those that failed, *.failed with a sentence;
/// writes gpu-day.json, results.jsonl and table.md to `output`. Errors: a file that is none of these
/// (`Input`), or that cannot be written (`Environment`).
Expected<void> writeTables(const std::string &folder, const std::string &output);

} // namespace voxc::gpu
