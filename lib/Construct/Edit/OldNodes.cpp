// Nodes and cells as the kinds of slots tell them.
#include "OldNodes.h"

#include "voxc/Layout/SlotKind.h"
#include "voxc/Layout/SubVolume.h"

#include <bit>

namespace voxc {
namespace {

using construct::Node;

/// As in construct-runtime/voxc_construct.h: both sets of bits share one word, or have words of their own.
unsigned maskWords(const Stratum &stratum) {
  const int children = 1 << stratum.log2Children();
  return static_cast<unsigned>(2 * children <= 32 ? 1 : children / 16);
}

/// The bits of the children that are not empty.
std::uint64_t filledOf(const Stratum &stratum, const Node &node) {
  const int children = 1 << stratum.log2Children();
  if (maskWords(stratum) == 1)
    return node.masks[0] & construct::ones(static_cast<unsigned>(children));
  return node.masks[0] | (children > 32 ? std::uint64_t{node.masks[1]} << 32 : 0);
}

} // namespace

/// A record without masks is a leaf.
Node OldNodes::record(unsigned level, std::uint64_t at) const {
  Node node = {Node::Inner, words_[at]};
  std::uint32_t any = 0;
  for (unsigned i = 0; i < maskWords(stratum(level)); ++i)
    any |= node.masks[i] = words_[at + 1 + i];
  return any == 0 ? Node::leaf(words_[at]) : node;
}

Node OldNodes::root(unsigned level, Ref ref) const {
  const Stratum &own = stratum(level);
  const std::uint64_t at = reader().wordOf(ref);
  if (own.hasRecords())
    return record(level, at);
  return own.depth == 0 ? Node::leaf(words_[at]) : Node{Node::Inner, ref};
}

void OldNodes::records(unsigned level, const Node &node, ChildVisit visit) const {
  std::uint64_t at = reader().wordOf(node.value);
  for (std::uint64_t rest = filledOf(stratum(level), node); rest != 0; rest &= rest - 1) {
    visit(static_cast<std::uint64_t>(std::countr_zero(rest)), record(level, at));
    at += 1 + maskWords(stratum(level));
  }
}

void OldNodes::children(unsigned level, const Node &node, ChildVisit visit) const {
  const Stratum &own = stratum(level);
  if (own.hasRecords())
    return records(level, node, visit);
  const WordReader words = reader();
  own.slots->visit(words, own, words.wordOf(node.value), [&](Int3 place, const Child &child) {
    visit(mortonCode(place),
          child.leaf ? Node::leaf(cellValue(words, own, child)) : Node{Node::Inner, layout_.refOf(child.at)});
  });
}

void OldNodes::cells(unsigned level, Ref ref, CellVisit visit) const {
  const Stratum &own = stratum(level);
  const WordReader words = reader();
  const Int3 shape = own.log2Shape;
  own.slots->visit(words, own, words.wordOf(ref), [&](Int3 place, const Child &child) {
    const auto row = static_cast<std::uint64_t>(place.y) + (static_cast<std::uint64_t>(place.z) << shape.y);
    visit(static_cast<std::uint64_t>(place.x) + (row << shape.x), cellValue(words, own, child));
  });
}

std::uint32_t OldNodes::cell(unsigned level, Ref ref, std::uint64_t number) const {
  const Stratum &own = stratum(level);
  const Int3 shape = own.log2Shape;
  const auto along = [&](std::uint64_t rest, int bits) {
    return static_cast<std::int32_t>(rest & ((std::uint64_t{1} << bits) - 1));
  };
  const Int3 place = {along(number, shape.x), along(number >> shape.x, shape.y),
                      along(number >> (shape.x + shape.y), shape.z)};
  const WordReader words = reader();
  const Child child = own.slots->child(words, own, words.wordOf(ref), place);
  return child.exists ? cellValue(words, own, child) : 0;
}

std::span<const std::uint32_t> OldNodes::wordsOf(unsigned level, Ref ref) const {
  const Stratum &own = stratum(level);
  const WordReader words = reader();
  const std::uint64_t at = words.wordOf(ref);
  return words_.subspan(at, own.slots->size(words, own, at));
}

} // namespace voxc
