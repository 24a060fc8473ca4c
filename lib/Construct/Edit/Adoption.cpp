// Down the levels, from one node to those below.
#include "Adoption.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {

using construct::Node;

Adoption::Adoption(const OldNodes &nodes, NodeStore &store, std::uint64_t words)
    : nodes_(nodes), store_(store), visited_(std::size_t{nodes.layout().refOf(words)} + 1) {}

/// A node and a sub-volume that begin at one word are one.
bool Adoption::isFirstTime(Ref ref) {
  const bool isNew = !visited_[ref];
  visited_[ref] = true;
  return isNew;
}

void Adoption::cell(unsigned level, std::uint32_t value) {
  if (!nodes_.layout().holdsVoxels(level - 1))
    subVolume(level + 1, value);
}

/// The words of the leaves of a node that have words of their own.
void Adoption::leafWords(unsigned level, const Node &node) {
  const Stratum &stratum = nodes_.stratum(level);
  if (!stratum.hasLeafWords())
    return;
  const WordReader words = nodes_.reader();
  stratum.slots->visit(words, stratum, words.wordOf(node.value), [&](Int3, const Child &child) {
    if (child.leaf && isFirstTime(nodes_.layout().refOf(child.at)))
      store_.adoptLeaf(level, words[child.at], nodes_.layout().refOf(child.at));
  });
}

void Adoption::node(unsigned level, int layers, const Node &node) {
  if (node.kind == Node::Leaf)
    return cell(level, node.value);
  if (node.kind == Node::Empty || !isFirstTime(node.value))
    return;
  if (!nodes_.stratum(level).hasRecords())
    store_.adopt(level, nodes_.wordsOf(level, node.value), node.value);
  leafWords(level, node);
  if (layers == 1 && nodes_.layout().holdsVoxels(level - 1))
    return;
  nodes_.children(level, node,
                  [&](std::uint64_t, const Node &child) { this->node(level, layers - 1, child); });
}

void Adoption::subVolume(unsigned level, Ref ref) {
  if (ref == 0)
    return;
  const Stratum &stratum = nodes_.stratum(level);
  if (!stratum.isGrid())
    return node(level, stratum.depth, nodes_.root(level, ref));
  if (!isFirstTime(ref))
    return;
  if (stratum.sharing == Sharing::Level)
    store_.adopt(level, nodes_.wordsOf(level, ref), ref);
  if (!nodes_.layout().holdsVoxels(level - 1))
    nodes_.cells(level, ref, [&](std::uint64_t, std::uint32_t value) { subVolume(level + 1, value); });
}

} // namespace voxc
