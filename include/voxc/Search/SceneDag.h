// A scene as one directed acyclic graph from its bounding cube down to single voxels, in which equal cubes
// are one. From it follows how many words every format takes, without building any (voxc/Search/SizeModel.h).
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace voxc {

class SceneDag {
public:
  /// When two cubes are equal.
  enum class Detail {
    Shape,   ///< The same voxels are there.
    Colours, ///< And have the same colours.
  };

  /// A cube that is not empty: which of its octants are not, in Morton order, and their numbers among the
  /// different cubes of half its side.
  struct Node {
    std::uint32_t mask;
    std::span<const std::uint32_t> children;
  };

  struct Options {
    Detail detail = Detail::Shape;
    int log2Side = 0; ///< The cube has 2^log2Side voxels a side at least, and as many as the source needs.
    std::size_t mostNodes = std::size_t{1} << 28; ///< About 30 bytes each.
    /// Is called with the words of bricks of 8^3 cells, in Morton order, as they are read; all that are not
    /// empty are among them. May be null.
    std::function<void(std::span<const std::uint32_t> cells)> look;
  };

  /// Reads a source once. Errors: its own, interrupted; more different cubes than `mostNodes`
  /// (`Environment`).
  static Expected<SceneDag> build(VoxelSource &source, const Options &options, const Progress &progress = {});

  /// The graph of the same scene without its colours.
  SceneDag shape() const;

  /// log2 of the voxels along a side of the whole.
  int log2Side() const { return static_cast<int>(layers_.size()) - 1; }
  /// True if there is no voxel at all.
  bool isEmpty() const { return layers_.back().count() == 0; }
  /// How many different cubes of 2^height voxels a side there are, height 0 to `log2Side`. They are numbered
  /// from 0 on. Of height 0 they are voxels: one, or one for each colour.
  std::size_t count(int height) const { return layer(height).count(); }
  /// One of them; height 1 or more.
  Node node(int height, std::size_t number) const { return layer(height).node(number); }
  /// The colour of a voxel of a graph that has colours, by its number.
  std::uint32_t voxel(std::size_t number) const { return layer(0).words[number]; }
  /// How often each of them is there in the whole scene.
  std::span<const std::uint64_t> occurrences(int height) const { return layer(height).occurrences; }

private:
  friend class SceneDagBuilder;

  struct Layer {
    std::vector<std::uint32_t> words; ///< Of each node its mask, then its children.
    std::vector<std::uint64_t> begins;
    std::vector<std::uint64_t> occurrences;

    std::size_t count() const { return begins.size(); }
    Node node(std::size_t number) const;
  };

  const Layer &layer(int height) const { return layers_[static_cast<std::size_t>(height)]; }
  void countOccurrences();
  Layer shapeOf(const Layer &layer, std::vector<std::uint32_t> &numbers) const;

  std::vector<Layer> layers_; ///< By height. Nodes of height 0 are a word of colour each, in place of a mask.
};

} // namespace voxc
