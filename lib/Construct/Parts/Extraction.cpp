// Going down a volume by the records of its strata, and copying what is met.
#include "Extraction.h"

#include "Layout/Masks.h"
#include "Layout/Places.h"
#include "voxc/Layout/SubVolume.h"
#include "voxc/Layout/Values.h"

namespace voxc {
namespace {

/// How construction writes the nodes of a stratum.
BlockRecord::Kind nodeKind(const Stratum &stratum) {
  return stratum.sharing == Sharing::None ? BlockRecord::Append : BlockRecord::Intern;
}

Int3 placeIn(const Stratum &stratum, Int3 cell, int layer) {
  const auto along = [&](int axis) {
    return cell[axis] >> stratum.log2Shape[axis] * (layer - 1) & ((1 << stratum.log2Shape[axis]) - 1);
  };
  return {along(0), along(1), along(2)};
}

std::uint64_t cubed(int log2Side) { return std::uint64_t{1} << 3 * log2Side; }

} // namespace

/// Nodes of two layers whose leaves are alike are one block: all below it is larger by so much then.
Extraction::Placed Extraction::Placed::inLayer(int other, int log2Shape) const {
  const int up = log2Shape * (other - layer);
  return {at, other, up >= 0 ? voxels * cubed(up) : voxels / cubed(-up)};
}

Fragment Extraction::cube(Int3 low, int log2Side) {
  Fragment fragment;
  fragment.cube = {low, log2Side};
  fragment.words = {0};
  if (layout_.hasArray())
    fragment.array.assign(kIndexedWords, 0);
  fragment.colour = layout_.hasOneColour() ? words_[1] : 0;
  fragment_ = &fragment;
  placed_.clear();
  const std::size_t index = layout_.stratumOfPart(log2Side);
  if (const Found root = subVolumeAround(index, low); root.at != 0) {
    if (layout_.strata[index].isGrid())
      partOfGrid(index, root, low, log2Side);
    else
      fragment.node = partOfTree(index, root, low, log2Side);
  }
  fragment_ = nullptr;
  return fragment;
}

/// The sub-volume of strata[index] that a voxel lies in, if there is one.
Extraction::Found Extraction::subVolumeAround(std::size_t index, Int3 low) const {
  const Int3 log2 = layout_.log2Extent();
  if (!contains({1 << log2.x, 1 << log2.y, 1 << log2.z}, low))
    return {};
  Found found = {words_.wordOf(words_[0]), 0};
  for (std::size_t i = 0; i < index && found.at != 0; ++i) {
    const Lookup below = lookUp(words_, layout_.strata[i], found.at, low >> layout_.strata[i].log2Cell);
    found = {words_.wordOf(below.value), found.rank + below.rank};
  }
  return found;
}

/// Takes the values of the part's voxels, of which `rank` is that of the first: where they stand apart, they
/// are next to each other.
void Extraction::values(std::uint64_t rank, std::uint64_t count) {
  if (layout_.ranksVoxels())
    for (std::uint64_t i = 0; i < count; ++i)
      fragment_->values.push_back(valueOfRank(words_, layout_.payload, rank + i));
}

construct::Node Extraction::partOfTree(std::size_t index, Found root, Int3 low, int log2Side) {
  const Stratum &stratum = layout_.strata[index];
  const bool isApart = layout_.ranksVoxels();
  const Int3 lowCell = low >> stratum.log2Cell;
  Found found = root;
  const auto counted = [&](construct::Node result, std::uint64_t voxels) {
    fragment_->voxels = voxels;
    result.voxels = isApart ? static_cast<std::uint32_t>(voxels) : 0;
    values(found.rank, voxels);
    return result;
  };
  const auto leaf = [&](std::uint32_t value, int log2Cells) {
    const Placed below = cell(index, value);
    return counted(construct::Node::leaf(below.at), below.voxels * cubed(log2Cells));
  };
  const int partLayers = (log2Side - stratum.log2Cell) / std::max(stratum.log2Shape.x, 1);
  for (int layer = stratum.depth; layer > partLayers; --layer) {
    const int log2Child = stratum.log2Shape.x * (layer - 1);
    const Child child = stratum.slots->child(words_, stratum, found.at, placeIn(stratum, lowCell, layer));
    if (!child.exists)
      return {};
    found = {child.at, found.rank + voxelsBefore(child, log2Child)};
    if (!child.leaf)
      continue;
    found.rank += ranksInLeaf(stratum, child, log2Child, lowCell).first;
    return leaf(cellValue(words_, stratum, child), log2Side - stratum.log2Cell);
  }
  if (partLayers == 0)
    return leaf(words_[found.at], 0);
  const std::uint64_t at = found.at;
  const Placed placed = node(index, at, partLayers);
  construct::Node result = counted({construct::Node::Inner, placed.at}, placed.voxels);
  const bool isRecord = stratum.hasRecords();
  for (std::uint64_t i = 0; i < MaskShape(stratum).words(); ++i)
    result.masks[i] = words_[at + (isRecord ? 1 : 0) + i];
  return result;
}

void Extraction::partOfGrid(std::size_t index, Found root, Int3 low, int log2Side) {
  const Stratum &stratum = layout_.strata[index];
  const bool isApart = layout_.ranksVoxels();
  const int log2Cells = log2Side - stratum.log2Cell;
  const Int3 first = placeIn(stratum, low >> stratum.log2Cell, 1);
  for (std::uint64_t code = 0; code < cubed(log2Cells); ++code) {
    const Int3 place = first + mortonCell(code);
    if ((place.x >> stratum.log2Shape.x | place.y >> stratum.log2Shape.y | place.z >> stratum.log2Shape.z) !=
        0)
      continue;
    const Lookup found = lookUp(words_, stratum, root.at, place);
    if (found.value == 0)
      continue;
    Placed below = cell(index, found.value);
    fragment_->voxels += below.voxels;
    const std::uint64_t rank = root.rank + found.rank;
    std::uint64_t apart = 0;
    if (isApart && layout_.holdsVoxels(index))
      below.at = valueOfRank(words_, layout_.payload,
                             rank); // Its place among the values is for the whole grid to say.
    else if (isApart)
      values(rank, apart = below.voxels);
    fragment_->cells.push_back({{place.x, place.y, place.z}, below.at, static_cast<std::uint32_t>(apart)});
  }
}

/// A cell's terminating integer: a voxel stays, and a sub-volume is copied.
Extraction::Placed Extraction::cell(std::size_t index, std::uint32_t value) {
  return layout_.holdsVoxels(index) ? Placed{.at = value, .voxels = 1}
                                    : subVolume(index + 1, words_.wordOf(value));
}

Extraction::Placed Extraction::subVolume(std::size_t index, std::uint64_t at) {
  if (const Placed *known = placed_.find(at))
    return *known;
  const Stratum &stratum = layout_.strata[index];
  if (stratum.isGrid())
    return grid(index, at);
  if (stratum.sharing == Sharing::SubVolume)
    fragment_->blocks.push_back({BlockRecord::Forget, static_cast<std::uint32_t>(index + 1), 0});
  if (stratum.depth > 0) {
    const Placed root = node(index, at, stratum.depth);
    return stratum.hasRecords() ? record(index, at, root) : root;
  }
  const Placed below = cell(index, words_[at]);
  if (stratum.hasRecords())
    return record(index, at, below);
  const Ref leaf = block(index, BlockRecord::InternLeaf, Block::Leaf, at, 1);
  placed_[at] = {.at = leaf, .voxels = below.voxels};
  return {.at = leaf, .voxels = below.voxels};
}

Extraction::Placed Extraction::grid(std::size_t index, std::uint64_t at) {
  const Stratum &stratum = layout_.strata[index];
  Placed placed;
  stratum.slots->visit(words_, stratum, at, [&](Int3, const Child &child) {
    placed.voxels += cell(index, cellValue(words_, stratum, child)).voxels;
  });
  placed.at = block(index, nodeKind(stratum), Block::Node, at, stratum.slots->size(words_, stratum, at));
  placed_[at] = placed;
  return placed;
}

/// A node of a tree, after all that is below it. In a layout of siblings, its children's records: a record
/// goes where its parent's children go.
Extraction::Placed Extraction::node(std::size_t index, std::uint64_t at, int layer) {
  const Stratum &stratum = layout_.strata[index];
  const bool isRecord = stratum.hasRecords();
  const std::uint64_t block = isRecord ? words_.wordOf(words_[at]) : at;
  if (const Placed *known = placed_.find(block))
    return known->inLayer(layer, stratum.log2Shape.x);
  Placed placed;
  std::uint64_t children = 0, leaves = 0;
  stratum.slots->visit(words_, stratum, at, [&](Int3, const Child &child) {
    ++children;
    if (!child.leaf) {
      placed.voxels += node(index, child.at, layer - 1).voxels;
      return;
    }
    ++leaves;
    const std::uint64_t voxels =
        layout_.holdsVoxels(index) ? 1 : cell(index, cellValue(words_, stratum, child)).voxels;
    placed.voxels += voxels * cubed(stratum.log2Shape.x * (layer - 1));
  });
  if (leaves > 0 && stratum.hasLeafWords())
    leafWords(index, at);
  const std::uint64_t size = stratum.slots->size(words_, stratum, at);
  placed.at = this->block(index, nodeKind(stratum), Block::Node, block, isRecord ? size * children : size);
  placed.layer = layer;
  placed_[block] = placed;
  return placed;
}

/// The record of a root, which has no siblings.
Extraction::Placed Extraction::record(std::size_t index, std::uint64_t at, const Placed &children) {
  const Stratum &stratum = layout_.strata[index];
  const Ref placedAt = block(index, BlockRecord::Append, Block::Node, at, 1 + MaskShape(stratum).words());
  const Placed placed = {.at = placedAt, .voxels = children.voxels};
  placed_[at] = placed;
  return placed;
}

/// The words of a node's leaves, as construction writes them: after all that is below, right before the node.
void Extraction::leafWords(std::size_t index, std::uint64_t node) {
  const Stratum &stratum = layout_.strata[index];
  stratum.slots->visit(words_, stratum, node, [&](Int3, const Child &child) {
    if (child.leaf && !placed_.find(child.at))
      placed_[child.at] = {.at = block(index, BlockRecord::InternLeaf, Block::Leaf, child.at, 1)};
  });
}

/// Copies a block whose references lead to what was copied before. Returns where it stands now.
Ref Extraction::block(std::size_t index, BlockRecord::Kind kind, Block what, std::uint64_t at,
                      std::uint64_t count) {
  const Stratum &stratum = layout_.strata[index];
  const bool isIndexed = stratum.inArray();
  std::vector<std::uint32_t> &words = isIndexed ? fragment_->array : fragment_->words;
  const auto begin = static_cast<std::ptrdiff_t>(words.size());
  if (isIndexed) {
    const std::uint64_t cells = stratum.slots->array->block(words_, arrayOf(stratum), at);
    words.insert(words.end(), {static_cast<std::uint32_t>(cells), static_cast<std::uint32_t>(cells >> 32)});
  } else {
    for (std::uint64_t i = 0; i < count; ++i)
      words.push_back(words_[at + i]);
  }
  const auto relocation = [&](Ref ref) {
    const Placed *found = placed_.find(layout_.leadsIntoArray(index) ? arrayOf(layout_.strata[index + 1]) +
                                                                           kIndexedWords * std::uint64_t{ref}
                                                                     : words_.wordOf(ref));
    return found ? found->at : Ref{0};
  };
  relocate(std::span(words).subspan(static_cast<std::size_t>(begin)), stratum, what,
           layout_.holdsVoxels(index), relocation);
  fragment_->blocks.push_back({kind, static_cast<std::uint32_t>(index + 1), count});
  return static_cast<Ref>(isIndexed ? static_cast<std::uint64_t>(begin) / kIndexedWords
                                    : static_cast<std::uint64_t>(begin));
}

} // namespace voxc
