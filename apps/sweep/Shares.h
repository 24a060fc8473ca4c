// A sweep cut into shares, which processes on one machine or on many measure side by side.
#pragma once

#include "sweep/Cells.h"

#include "voxc/Measure/RecordFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

/// One of `count` shares, from 0 to count - 1.
struct Share {
  std::uint64_t index = 0, count = 1;
};

/// For each cell the index of its share. Shares are runs of the cells' order, so that formats which are
/// compared stay together, of as many volumes each as can be. Cells that share a volume have one share.
std::vector<std::uint64_t> shareOfEach(const std::vector<Cell> &cells, std::uint64_t count);

/// Keeps the cells of a share alone.
void keepShare(std::vector<Cell> &cells, const Share &share);

/// What tells sweeps apart, whatever machine looks at them: all that their cells are known by, but what
/// devices are called there.
std::string sweepDigest(const SweepAxes &axes);

/// The file of a folder for the records of a share, such as "share-3-of-8-DIGEST.jsonl". It is read as every
/// file of records is, and joined to the others when all shares are measured.
std::string shareFileName(const std::string &sweepDigest, const Share &share);

/// What the names of all shares of a sweep end with: "-of-8-DIGEST.jsonl".
std::string shareFileEnding(const std::string &sweepDigest, std::uint64_t count);

/// Moves the records of the folder's share files to the end of its results, but for files whose names end
/// with `but`, if it is not "". Errors: of reading and writing.
Expected<void> joinShares(const std::string &folder, const std::string &but, RecordWriter &results);

} // namespace voxc::tool::bench
