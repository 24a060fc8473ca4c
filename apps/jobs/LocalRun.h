// Carrying out jobs on processes of this machine.
#pragma once

#include "jobs/Jobs.h"

#include "common/Json.h"

namespace voxc::tool {

/// Does what is missing on `processes` processes at a time, level after level. What a process leaves undone
/// is done again by another one, as long as some of it gets done. Adds `missing` and `rounds` to the figures.
/// Errors: those of an item that fails twice, or the work was stopped.
Expected<void> runLocally(const Jobs &jobs, unsigned processes, const JobWatch &watch, Json &figures);

} // namespace voxc::tool
