// The points of a PLY file, one after the other.
#pragma once

#include "Mesh/Ply/PlyColour.h"
#include "Mesh/Ply/PlyReader.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace voxc {

/// A row of the element `vertex`.
struct PointRow {
  std::array<double, 3> position;
  std::uint64_t number;
  std::uint32_t word; ///< 0 if it has no colour.
};

class PointRows {
public:
  explicit PointRows(PlyReader &reader);

  bool hasPositions() const { return axes_[0] && axes_[1] && axes_[2]; }
  /// True if x, y and z are integers.
  bool areIndices() const;

  /// Calls `visit` for every point until it returns an error. To be called once. Errors: as
  /// `PlyReader::readRows`; interrupted.
  using Visit = std::function<Expected<void>(const PointRow &row)>;
  Expected<void> read(const Visit &visit, WorkingMemory &memory, const Progress &progress);

private:
  /// Where the rows lie, if all of them have the same size.
  struct Table {
    const char *rows;
    std::uint64_t stride;
    std::vector<std::uint64_t> offsets; ///< Of each property in a row.
  };

  std::optional<Table> findTable() const;
  Expected<void> readTable(const Table &table, const Visit &visit, WorkingMemory &memory,
                           const Progress &progress) const;
  PointRow pointOf(const PlyRow &row, std::uint64_t number) const;

  PlyReader &reader_;
  const PlyElement *vertices_;
  PlyColour colour_;
  std::array<std::optional<std::size_t>, 3> axes_;
};

} // namespace voxc
