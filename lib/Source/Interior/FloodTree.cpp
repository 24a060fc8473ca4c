// Flood fill: cubes that it has reached wait until it has spread from them.
#include "Source/Interior/FloodTree.h"

#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

namespace {

constexpr std::uint64_t kStepsBetweenLooks = 1 << 10;

Int3 cellsPerSide(int height) { return Int3{1, 1, 1} * (1 << 3 * height); }

Slices joined(const Slices &a, const Slices &b) {
  Slices both;
  for (std::size_t z = 0; z < 8; ++z)
    both[z] = a[z] | b[z];
  return both;
}

Slices without(const Slices &a, const Slices &b) {
  Slices left;
  for (std::size_t z = 0; z < 8; ++z)
    left[z] = a[z] & ~b[z];
  return left;
}

/// The cells of the brick in which one step from `reached` ends, and these themselves.
Slices grown(const Slices &reached, Step step) {
  Slices all = reached;
  for (const int sign : {1, -1}) {
    Slices moved = reached;
    for (int axis = 0; axis < 3; ++axis)
      if (step == Step::Ray)
        moved = joined(moved, shifted(moved, axis, sign));
      else
        all = joined(all, shifted(reached, axis, sign));
    all = joined(all, moved);
  }
  return all;
}

/// Calls `visit(direction, cells)` for each brick around one in which a step from `reached` may end, with the
/// cells there. A direction is 0 or one sign on each axis.
template <typename Visit> void forEachNeighbour(const Slices &reached, Step step, Visit visit) {
  for (const int sign : {1, -1})
    for (int axes = 1; axes < 8; ++axes) {
      if (step == Step::Face && (axes & (axes - 1)) != 0)
        continue;
      Slices cells = reached;
      Int3 direction;
      for (int axis = 0; axis < 3; ++axis) {
        const bool isAcross = (axes >> axis & 1) != 0;
        direction[axis] = isAcross ? sign : 0;
        if (isAcross)
          cells = carried(cells, axis, sign);
        else if (step == Step::Ray)
          cells = joined(cells, shifted(cells, axis, sign));
      }
      if (isAny(cells))
        visit(direction, cells);
    }
}

} // namespace

void FloodTree::touch(const Region &region) { root_ = touchChild(root_, {}, height_, region); }

std::uint32_t FloodTree::touchChild(std::uint32_t child, Int3 low, int height, const Region &region) {
  if (error_ || child == kReached)
    return child;
  if (child == kEmpty) {
    check(waiting_.push({low, height, kNoLeaf}));
    return kReached;
  }
  if (child == kFull) {
    // Who goes over faces does not ask which voxels are met.
    if (step_ == Step::Face)
      return child;
    child = height == 1 ? addLeaf(low, cellsBetween({}, {8, 8, 8})) : addNode(kFull);
    if (error_)
      return kFull;
  }
  if (height > 1)
    touchNode(child - kFirst, low, height, region);
  else
    touchLeaf(child - kFirst,
              region.cells ? *region.cells : cellsBetween(region.low - low, region.high - low));
  return child;
}

void FloodTree::touchNode(std::uint32_t node, Int3 low, int height, const Region &region) {
  const int log2Child = 3 * (height - 1);
  Int3 first;
  Int3 last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = std::max(region.low[axis] - low[axis], 0) >> log2Child;
    last[axis] = std::min((region.high[axis] - 1 - low[axis]) >> log2Child, 7);
  }
  for (Int3 at = first; at.z <= last.z; ++at.z)
    for (at.y = first.y; at.y <= last.y; ++at.y)
      for (at.x = first.x; at.x <= last.x; ++at.x) {
        const std::uint64_t place = mortonCode(at);
        const std::uint32_t child =
            touchChild(nodes_[node][place], low + at * (1 << log2Child), height - 1, region);
        // Nodes may have moved meanwhile.
        nodes_[node][place] = child;
      }
}

void FloodTree::touchLeaf(std::uint32_t number, const Slices &cells) {
  Leaf &leaf = leaves_[number];
  const Slices fresh = without(cells, leaf.touched);
  leaf.touched = joined(leaf.touched, cells);
  if (leaf.isWaiting != 0 || !isAny(without(fresh, leaf.voxels)))
    return;
  leaf.isWaiting = 1;
  check(waiting_.push({leaf.low, 1, number}));
}

void FloodTree::spread(const ReachedCube &cube) {
  const Int3 high = cube.low + cellsPerSide(cube.height);
  const Int3 one{1, 1, 1};
  if (step_ == Step::Ray) {
    touch({cube.low, high + one});
    touch({cube.low - one, high});
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    Region region{cube.low, high};
    region.low[axis] -= 1;
    region.high[axis] += 1;
    touch(region);
  }
}

void FloodTree::spread(std::uint32_t number) {
  Leaf &leaf = leaves_[number];
  leaf.isWaiting = 0;
  Slices reached = without(leaf.touched, leaf.voxels);
  for (Slices before{}; reached != before;) {
    before = reached;
    leaf.touched = joined(leaf.touched, grown(reached, step_));
    reached = without(leaf.touched, leaf.voxels);
  }
  const Int3 low = leaf.low;
  const Int3 side = cellsPerSide(height_);
  forEachNeighbour(reached, step_, [&](Int3 direction, const Slices &cells) {
    const Int3 at = low + direction * 8;
    if (contains(side, at))
      touch({at, at + Int3{8, 8, 8}, &cells});
  });
}

Expected<void> FloodTree::run() {
  while (!waiting_.empty() && !isStopped()) {
    const ReachedCube next = waiting_[waiting_.size() - 1];
    check(waiting_.resize(waiting_.size() - 1));
    if (next.leaf == kNoLeaf)
      spread(next);
    else
      spread(next.leaf);
  }
  return error_ ? Expected<void>(*error_) : Expected<void>();
}

Expected<void> FloodTree::floodFromOutside() {
  const Int3 side = cellsPerSide(height_);
  for (int axis = 0; axis < 3; ++axis) {
    Region low{{}, side};
    Region high{{}, side};
    low.high[axis] = 1;
    high.low[axis] = side[axis] - 1;
    touch(low);
    touch(high);
  }
  return run();
}

Expected<void> FloodTree::floodFrom(Int3 cell) {
  touch({cell, cell + Int3{1, 1, 1}});
  return run();
}

Expected<ScratchArray<Int3>> FloodTree::floodEveryPart() {
  ScratchArray<Int3> parts(memory_);
  floodUnreached(root_, {}, height_, parts);
  if (error_)
    return *error_;
  return parts;
}

void FloodTree::floodUnreached(std::uint32_t child, Int3 low, int height, ScratchArray<Int3> &parts) {
  if (error_ || child == kReached || child == kFull)
    return;
  const auto flood = [&](Int3 cell) {
    check(parts.push(cell));
    check(floodFrom(cell));
  };
  if (child == kEmpty)
    return flood(low);
  if (height > 1) {
    for (std::uint64_t i = 0; i < 512; ++i)
      floodUnreached(nodes_[child - kFirst][i], low + mortonCell(i) * (1 << 3 * (height - 1)), height - 1,
                     parts);
    return;
  }
  const auto unreached = [&] {
    const Leaf &leaf = leaves_[child - kFirst];
    return toMorton(without(without(cellsBetween({}, {8, 8, 8}), leaf.voxels), leaf.touched));
  };
  for (MortonBits cells = unreached(); isAny(cells) && !error_; cells = unreached()) {
    unsigned word = 0;
    while (cells[word] == 0)
      ++word;
    flood(low + mortonCell(64 * word + static_cast<unsigned>(std::countr_zero(cells[word]))));
  }
}

void FloodTree::clearReached() {
  for (Node &node : nodes_.span())
    std::ranges::replace(node, std::uint32_t{kReached}, std::uint32_t{kEmpty});
  for (Leaf &leaf : leaves_.span())
    leaf.touched = {};
  if (root_ == kReached)
    root_ = kEmpty;
}

std::uint32_t FloodTree::addNode(std::uint32_t children) {
  Node node;
  node.fill(children);
  check(nodes_.push(node));
  return static_cast<std::uint32_t>(nodes_.size() - 1 + kFirst);
}

std::uint32_t FloodTree::addLeaf(Int3 low, const Slices &voxels) {
  check(leaves_.push({voxels, {}, low, 0}));
  return static_cast<std::uint32_t>(leaves_.size() - 1 + kFirst);
}

bool FloodTree::isStopped() {
  if (steps_++ % kStepsBetweenLooks == 0 && progress_.stopped())
    check(Error::interrupted());
  memory_->relieve(1024);
  return error_.has_value();
}

} // namespace voxc
