// The cells that a report tells of: the records of all its folders.
#pragma once

#include "bench/Record.h"
#include "voxc/Support/Error.h"

#include <string>
#include <vector>

namespace voxc::report {

/// One cell: a format of a model, traced by a device.
using Cell = tool::bench::Record;

/// The cells of the folders in the order in which they first came; of two with the same `cell` the later one
/// counts. `model.picture` becomes a path that can be opened; one that does not lie in the record's folder is
/// left out. Errors: `Input` as of `readRecords`, or if there is no cell at all.
Expected<std::vector<Cell>> readCells(const std::vector<std::string> &folders);

} // namespace voxc::report
