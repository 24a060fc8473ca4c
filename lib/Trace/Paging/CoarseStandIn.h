// What a ray that waits for a page meets among the coarse blocks of a volume.
#pragma once

#include "CoarseTree.h"

#include "voxc/Trace/Ray.h"
#include "voxc/Trace/Tracer.h"

namespace voxc {

/// Blocks that stand in for pages. A ray goes on from the cell in which it waits, and finds the first box of
/// voxels that it comes to.
class CoarseStandIn {
public:
  explicit CoarseStandIn(CoarseTree tree) : tree_(std::move(tree)) {}

  const CoarseTree &tree() const { return tree_; }

  enum class Outcome {
    Waits,   ///< For its page: the box looks large.
    Misses,  ///< It comes to no box, and so to no voxel.
    Answered ///< By the box; or it began in one that looks small, and missed all others.
  };
  struct Answer {
    Outcome outcome = Outcome::Waits;
    Hit hit;         ///< If it does not wait; without steps.
    float until = 0; ///< If it waits: it finds the same until it has come so far.
  };

  /// The t at which a ray enters a cell, or 0 if it begins there.
  static double entryOf(const Ray &ray, Int3 cell);

  /// What a ray meets that has met nothing before t = `entry`. A miss is certain; rays for which it would not
  /// be, such as those from very far away, wait.
  Answer answer(const Ray &ray, double entry, const CoarseView &view) const;

private:
  CoarseTree tree_;
};

} // namespace voxc
