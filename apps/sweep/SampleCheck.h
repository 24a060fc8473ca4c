// Hits of a sample of rays that another machine traced, against the exact oracle.
#pragma once

#include "voxc/Measure/Record.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Ray.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

/// The rays of the sample that is packed for a record's cell, evenly spread over the cell's rays. Errors:
/// what was kept of the rays in the cache of `folder` cannot be read (`Input`).
Expected<std::vector<Ray>> packedSample(const Record &record, const std::string &folder);

/// The name of that sample's file: the same for all cells with the same rays.
std::string sampleName(const Record &record);

/// Compares with oracles made from the volumes in a folder's cache, one for each model and size.
class SampleCheck {
public:
  explicit SampleCheck(std::string folder) : folder_(std::move(folder)) {}

  /// Adds error figures and steps to `record`. Errors: as `packedSample`; the volume is not in the cache, or
  /// there are not as many hits as rays (`Input`).
  Expected<void> add(Record &record, std::span<const Hit> hits);

private:
  struct Known {
    std::vector<Ray> rays;
    std::vector<Hit> exact;
  };
  Expected<const Oracle *> oracleOf(const Record &record);

  std::string folder_;
  std::map<std::string, Oracle> oracles_;
  std::map<std::string, Known> samples_;
};

} // namespace voxc::tool::bench
