// The words of a volume as nodes of construction: what generated code for edits asks of what was there
// before.
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Support/FunctionRef.h"

#include "voxc_host.h"

#include <cstdint>
#include <span>

namespace voxc {

/// Reads sub-volumes of a layout that can be edited. Levels are numbered from 1. The layout outlives this;
/// the words need not have been checked if they were made by a build.
class OldNodes {
public:
  explicit OldNodes(const Layout &layout) : layout_(layout) {}

  /// From now on these are the words.
  void read(std::span<const std::uint32_t> words) { words_ = words; }

  /// The root of the sub-volume of a tree to which `ref`, which is not 0, leads.
  construct::Node root(unsigned level, Ref ref) const;

  /// Receives a child that is not empty, and its place in Morton order.
  using ChildVisit = FunctionRef<void(std::uint64_t index, const construct::Node &child)>;
  /// The children of an inner node.
  void children(unsigned level, const construct::Node &node, ChildVisit visit) const;

  /// Receives the number and the value of a cell that is not empty.
  using CellVisit = FunctionRef<void(std::uint64_t cell, std::uint32_t value)>;
  /// The cells of the grid to which `ref`, which is not 0, leads.
  void cells(unsigned level, Ref ref, CellVisit visit) const;
  /// The value of one of them.
  std::uint32_t cell(unsigned level, Ref ref, std::uint64_t number) const;

  /// The words of a node or a grid, those of its children apart.
  std::span<const std::uint32_t> wordsOf(unsigned level, Ref ref) const;

  const Stratum &stratum(unsigned level) const { return layout_.strata[level - 1]; }
  const Layout &layout() const { return layout_; }
  WordReader reader() const { return layout_.reader(words_); }

private:
  construct::Node record(unsigned level, std::uint64_t at) const;
  void records(unsigned level, const construct::Node &node, ChildVisit visit) const;

  const Layout &layout_;
  std::span<const std::uint32_t> words_;
};

} // namespace voxc
