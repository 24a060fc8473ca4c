// The points of a PLY file, by number.
#pragma once

#include "Mesh/Ply/PlyReader.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

struct PlyPoint {
  std::array<double, 3> position;
  std::uint32_t word; ///< 0: the point has no colour and is none.
};

/// Points that may be read again and again, from several passes.
class PointList {
public:
  virtual ~PointList() = default;

  virtual std::uint64_t size() const = 0;
  /// Writes the points from `first` on.
  virtual void read(std::uint64_t first, std::span<PlyPoint> points) const = 0;
  /// False if all are white because nothing says otherwise.
  virtual bool hasColours() const = 0;
  /// Why so many points have the word 0.
  virtual std::string saysDropped(std::uint64_t count) const = 0;
  /// What else is to be said of them; one sentence each.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// True if an element has the properties x, y and z; and if they are integers.
bool hasPoints(const PlyHeader &header);
bool areIndices(const PlyHeader &header);

/// The points of a file that has some; in place if the rows are binary and of one size, else copied.
/// `reader` must outlive the list. Errors: as `PlyReader::readRows`; no memory; interrupted.
Expected<std::unique_ptr<PointList>>
readPointList(PlyReader &reader, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
