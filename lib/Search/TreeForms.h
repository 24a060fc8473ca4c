// The nodes of trees over a scene: which cubes are leaves, and which nodes are written alike.
#pragma once

#include "InternTable.h"

#include "voxc/Search/SceneDag.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// How many of what trees are made of.
struct TreeCount {
  std::uint64_t roots = 0;  ///< Sub-volumes.
  std::uint64_t nodes = 0;  ///< Theirs, the roots among them.
  std::uint64_t inner = 0;  ///< Children that are nodes.
  std::uint64_t leaves = 0; ///< Children that are leaves.
  std::uint64_t values = 0; ///< Words that leaves have the values of, where they have words.

  void add(const TreeCount &other, std::uint64_t times = 1);
};

/// Which cubes trees are over, and how they are made of nodes.
struct TreeShape {
  int bottom = 0;      ///< Cells have 2^bottom voxels a side,
  int branch = 1;      ///< and nodes 2^branch children an axis.
  bool ranked = false; ///< Nodes that have other numbers of voxels differ.

  bool operator==(const TreeShape &) const = default;
};

/// Trees whose equal cells have one value. Eight (or 64) equal leaves are one leaf, unless they are all of a
/// sub-volume, and a node is known by its masks and children alone: so nodes of several heights can be one.
class TreeForms {
public:
  TreeForms(const SceneDag &dag, const TreeShape &shape);

  /// Of all sub-volumes of 2^top voxels a side, where equal nodes are written once.
  TreeCount shared(int top) const;
  /// Where equal nodes of one sub-volume are written once.
  TreeCount sharedInEach(int top) const;
  /// Where every node is written.
  TreeCount unshared(int top) const;

private:
  /// What stands for a cube in the node above.
  struct Form {
    bool leaf = false;
    std::uint32_t number = 0; ///< Of a node, or of a leaf's value.
  };

  /// Of one kind of node.
  struct NodeKind {
    int layer = 0; ///< The lowest on which it is found, from 1 on.
    std::uint32_t inner = 0;
    std::uint32_t leaves = 0;
  };

  int layers() const { return static_cast<int>(forms_.size()) - 1; }
  int layerOf(int height) const { return (height - shape_.bottom) / shape_.branch; }
  int heightOf(int layer) const { return shape_.bottom + layer * shape_.branch; }
  void makeLayer(int layer);
  Form join(int layer, std::size_t number);
  TreeCount wholeRoot() const;

  const SceneDag &dag_;
  TreeShape shape_;
  std::vector<std::vector<Form>> forms_;           ///< By layer, and number of the cube; layer 0 are cells.
  std::vector<std::vector<std::uint64_t>> voxels_; ///< In ranked trees, likewise.
  std::vector<NodeKind> kinds_;
  InternTable table_;
  std::vector<std::uint32_t> words_; ///< Of the kinds: masks, then children, each with its voxels if ranked.
  std::vector<std::uint64_t> begins_;
};

/// Trees whose cells all have values of their own: every node is written, and nothing is a leaf but cells.
TreeCount treeOfUniqueCells(const SceneDag &dag, const TreeShape &shape, int top);

/// How many cells of 2^bottom voxels a side the different cubes of 2^top voxels have that are not empty.
std::vector<std::uint64_t> countCells(const SceneDag &dag, int bottom, int top);

} // namespace voxc
