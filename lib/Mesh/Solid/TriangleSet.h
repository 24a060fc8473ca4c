// Some of the triangles of a scene, and going through them.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"

#include <memory>

namespace voxc {

/// A bit for each triangle, by its number. A set that was never sized is empty.
class TriangleSet {
public:
  explicit TriangleSet(std::shared_ptr<WorkingMemory> memory) : bits_(std::move(memory)) {}

  /// Makes room for this many, none of which is in the set. Error: no memory.
  Expected<void> resize(std::uint64_t triangles) { return bits_.resize((triangles + 63) / 64); }
  void add(std::uint64_t number) {
    bits_[number / 64] |= std::uint64_t{1} << number % 64;
    isEmpty_ = false;
  }
  bool has(std::uint64_t number) const {
    return number / 64 < bits_.size() && (bits_[number / 64] >> number % 64 & 1) != 0;
  }
  bool empty() const { return isEmpty_; }

private:
  ScratchArray<std::uint64_t> bits_;
  bool isEmpty_ = true;
};

/// Calls `visit(number, cursor)` for each triangle of a scene, or for those of a set: an `Expected<void>`.
/// Errors: those of `visit`, interrupted.
template <typename Visit>
Expected<void> forEachTriangle(const TriangleScene &scene, const MeshModel &model, const TriangleSet *only,
                               WorkingMemory &memory, const Progress &progress, Visit visit) {
  constexpr std::uint64_t kBetweenLooks = 64;
  TriangleCursor cursor(scene, model.numbers);
  for (std::uint64_t number = 0; number < model.numbers.size(); ++number) {
    if (number % kBetweenLooks == 0) {
      if (progress.stopped())
        return Error::interrupted();
      memory.relieve();
    }
    if (only && !only->has(number))
      continue;
    cursor.moveTo(number);
    VOXC_TRY(visit(number, cursor));
  }
  return {};
}

} // namespace voxc
