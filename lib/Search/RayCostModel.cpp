// Rays through formats that are not built.
//
// Where a cell is empty, the graph tells how high the empty cube around it is. A format knows of that what
// its levels know: a grid the cell, a tree the cube, distances a box. So the steps of its kernel follow, and
// what it reads on the way.
#include "voxc/Search/RayCostModel.h"

#include "LineSet.h"
#include "LookUp.h"
#include "PacketTurns.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <vector>

namespace voxc {

namespace {

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  a = (a ^ (b + 0x9e3779b97f4a7c15u)) * 0xd6e8feb86659fd93u;
  return a ^ a >> 29;
}

/// What the rays of a packet have done in common so far.
struct Packet {
  LineSet lines;     ///< That any has read.
  PacketTurns turns; ///< In which any has been.
  /// Of the ray's last look-up in each level: its turn of the level's loop since that was entered, and a
  /// number that stands for the turns of all loops down to it.
  struct {
    std::vector<std::uint64_t> loops, places;
  } path;

  bool isPlain; ///< All levels are grids that one loop traverses: of their turns nothing is counted.

  Packet(const std::vector<LevelView> &levels, const Plan &plan)
      : isPlain((kindOf(plan.levelTraversal).fromRoot || levels.size() == 1) &&
                std::ranges::all_of(plan.layout.strata, &Stratum::isGrid)) {
    path.loops.resize(levels.size());
    path.places.resize(levels.size());
  }

  void clear() {
    lines.clear();
    turns.clear();
  }
};

/// The traversal of one ray.
class SimulatedTraversal {
public:
  SimulatedTraversal(const SceneDag &dag, Packet &packet, const Plan &plan,
                     const std::vector<LevelView> &levels, const Ray &ray, RayCost &cost)
      : packet_(packet), levels_(levels), isDirect_(kindOf(plan.levelTraversal).fromRoot),
        countsVisits_(kindOf(plan.levelTraversal).nests),
        isApart_(plan.layout.ranksVoxels() && kindOf(plan.layout.payload).varies),
        at_(ray, 1 << levels.front().top), path_(dag, levels.front().top), height_(levels.front().top),
        cost_(cost) {
    packet_.path.loops.front() = 0;
  }

  /// Adds what the ray costs. Returns its turns.
  std::size_t run() {
    if (at_.isInside())
      ++cost_.words; // Where the root is.
                     // No ray crosses more cells; one that float64 cannot place might come back to some.
    const std::size_t mostTurns = std::size_t{3} << levels_.front().top;
    while (at_.isInside() && turns_ < mostTurns) {
      ++turns_;
      const int empty = path_.find(at_.voxel());
      lookUp(empty);
      if (empty < 0) {
        cost_.colours += isApart_ ? 1 : 0;
        break;
      }
      step(empty);
    }
    return turns_;
  }

private:
  /// Goes down from the level where the traversal stands to the one that has the empty cell, or the voxel.
  void lookUp(int empty) {
    double visits = 1;
    for (std::size_t i = level_;; ++i, ++visits) {
      const LevelView &level = levels_[i];
      const bool isEmpty = empty >= level.bottom;
      const bool isVoxel = !isEmpty && i + 1 == levels_.size();
      const bool resumes = !isDirect_ && i == level_ && !kindOf(level.descent).restarts;
      const int from = resumes ? std::min(height_, level.top) : level.top;
      const int layers = level.layers(from, isEmpty ? empty : level.bottom);
      cost_.layers += layers;
      addToPacket(i, layers);
      cost_.probes += level.stratum.slots && level.stratum.slots->lookUpLoops ? 1 : 0;
      cost_.words += wordsRead(level, layers, isEmpty);
      cost_.lines += linesRead(i, from, layers, isEmpty);
      level_ = i;
      if (isEmpty || isVoxel)
        break;
    }
    cost_.lookups += countsVisits_ ? visits : 1;
    cost_.switches += isDirect_ ? 0 : visits - 1;
  }

  /// Adds what a look-up in a level costs beyond those that other rays of the packet make in the same turn of
  /// the loops for this level and those above.
  void addToPacket(std::size_t index, int layers) {
    if (packet_.isPlain)
      return;
    auto &[loops, places] = packet_.path;
    // A direct traversal has one loop, and goes through all levels in each turn; else each level's is in that
    // above.
    const bool loopsHere = !isDirect_ || index == 0;
    places[index] = mix(index == 0 ? 0 : places[index - 1], loopsHere ? ++loops[index] : 0);
    if (index + 1 < levels_.size())
      loops[index + 1] = 0;
    const PacketTurns::Added added = packet_.turns.add(places[index], layers);
    cost_.packetLayers += kSimulatedPacket * added.layers;
    if (!added.isFirst)
      return;
    cost_.packetTrees += levels_[index].stratum.isGrid() ? 0 : kSimulatedPacket;
    cost_.packetSwitches += isDirect_ || index == level_ ? 0 : kSimulatedPacket;
  }

  /// Lines that no ray of the packet has read: those of the nodes from a height down, or of the cell of a
  /// grid.
  int linesRead(std::size_t index, int from, int layers, bool isEmpty) {
    const LevelView &level = levels_[index];
    const auto node = [&](int height) {
      return (std::uint64_t{path_.number(height)} << 10 | static_cast<std::uint64_t>(height) << 4 | index);
    };
    const auto add = [&](std::uint64_t line) { return packet_.lines.add(line) ? 1 : 0; };
    if (!level.stratum.isGrid()) {
      int lines = 0;
      for (int layer = 0; layer < layers; ++layer)
        lines += add(node(from - layer * level.branch));
      return lines;
    }
    const std::uint64_t grid = mix(node(level.top), 0);
    const auto slot = isEmpty ? std::nullopt : slotLineOf(level, at_.voxel());
    return add(mix(grid, 2 * lineOf(level, at_.voxel()))) + (slot ? add(mix(grid, 2 * *slot + 1)) : 0);
  }

  /// Leaves what is empty, for the level that the traversal goes on from.
  void step(int empty) {
    const LevelView &level = levels_[level_];
    const Int3 before = at_.voxel();
    const EmptySpan span = spanAt(level, empty, isDirect_, at_, path_);
    if (level.region == EmptyRegion::Ball && !isDirect_)
      march(level, span);
    else
      at_.leave(span);
    if (isDirect_) {
      level_ = 0;
      return;
    }
    const std::size_t left = level_;
    while (level_ > 0 && !areInOneCube(before, at_.voxel(), levels_[level_].top))
      --level_;
    const int found = level_ == left ? empty : levels_[level_].bottom;
    height_ = std::max(found + levels_[level_].branch, commonHeight(before, at_.voxel()));
  }

  /// Steps from cell to cell as long as the distance allows, within the sub-volume.
  void march(const LevelView &level, const EmptySpan &distance) {
    for (int left = distance.count; left > 0; --left) {
      const Int3 before = at_.voxel();
      at_.leave({distance.log2Side, 1});
      ++cost_.marches;
      if (!at_.isInside() || !areInOneCube(before, at_.voxel(), level.top))
        break;
    }
  }

  Packet &packet_;
  const std::vector<LevelView> &levels_;
  bool isDirect_;
  bool countsVisits_; ///< Look-ups are counted level by level, else turn by turn.
  bool isApart_;      ///< Colours are.
  RayPosition at_;
  ScenePath path_;
  std::size_t turns_ = 0;
  std::size_t level_ = 0; ///< Where the next look-up begins,
  int height_;            ///< and in a tree with a stack, the height of the node.
  RayCost &cost_;
};

} // namespace

RayCost modelRayCost(const SceneDag &dag, std::span<const Ray> all, const Plan &plan) {
  std::vector<LevelView> levels;
  levels.reserve(plan.layout.strata.size());
  for (std::size_t i = 0; i < plan.layout.strata.size(); ++i)
    levels.emplace_back(plan.layout.strata[i], plan.traversals[i], i == 0);
  RayCost cost;
  Packet packet(levels, plan);
  const std::size_t packets = all.size() / kSimulatedPacket;
  for (std::size_t first = 0; first < packets * kSimulatedPacket; first += kSimulatedPacket) {
    std::size_t most = 0;
    packet.clear();
    for (const Ray &ray : all.subspan(first, kSimulatedPacket)) {
      const std::size_t turns = SimulatedTraversal(dag, packet, plan, levels, ray, cost).run();
      cost.turns += static_cast<double>(turns);
      most = std::max(most, turns);
    }
    cost.waits += static_cast<double>(most * kSimulatedPacket);
  }
  const auto rays = static_cast<double>(std::max<std::size_t>(packets * kSimulatedPacket, 1));
  for (double *part : {&cost.lookups, &cost.turns, &cost.words, &cost.layers, &cost.packetLayers,
                       &cost.packetTrees, &cost.probes, &cost.marches, &cost.waits, &cost.switches,
                       &cost.packetSwitches, &cost.lines, &cost.colours})
    *part /= rays;
  cost.levels = static_cast<double>(levels.size());
  return cost;
}

} // namespace voxc
