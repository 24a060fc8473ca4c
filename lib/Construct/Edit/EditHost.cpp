// From the table of functions to the change and the store.
#include "EditHost.h"

#include "Construct/Host/Serve.h"

#include <unordered_set>

namespace voxc {
namespace {

using construct::Node;
using construct::Voxel;

Int3 int3Of(Voxel voxel) { return {voxel.x, voxel.y, voxel.z}; }

EditHost &hostOf(void *self) { return *static_cast<EditHost *>(self); }

} // namespace

EditHost::EditHost(EditStore &store, const Layout &layout, Int3 extent)
    : BuildHost(store.nodes()), words_(store), facts_(layout.voxelFacts()), old_(layout), tally_(old_),
      extent_(extent), proof_(proofOfAll()) {
  fillTable();
}

/// That of the voxels that are there.
VoxelProof EditHost::proofOfAll() const {
  VoxelProof proof(facts_, true);
  if (kindOf(facts_.payload).oneColour && words_.words()[1] != 0)
    proof.prove({}, words_.words()[1]); // All others have this one.
  return proof;
}

void EditHost::begin(VoxelChange &change) {
  change_ = &change;
  more_ = 0;
  old_.read(words_.words());
  tally_.forget();
}

/// Only cubes within the extent become something as a whole.
CubeChange EditHost::changeOf(const Cube &cube) {
  CubeChange change = change_->of(cube);
  if (change.kind != CubeChange::Set)
    return change;
  for (int axis = 0; axis < 3; ++axis)
    if (cube.low[axis] + cube.side() > extent_[axis])
      return {CubeChange::Some};
  change.word = checked(cube.low, change.word);
  return change;
}

std::uint32_t EditHost::voxel(Int3 at, std::uint32_t old) {
  if (at.x >= extent_.x || at.y >= extent_.y || at.z >= extent_.z)
    return old;
  // Of a payload of one colour the words say only that there is a voxel; the change is told the colour.
  const bool isOne = old != 0 && kindOf(facts_.payload).oneColour;
  const std::uint32_t word = checked(at, change_->voxel(at, isOne ? proof_.colour() : old));
  more_ += (word != 0 ? 1 : 0) - (old != 0 ? 1 : 0);
  return word;
}

/// What the volume keeps of a voxel's word. A word that its format cannot keep fails the edit.
std::uint32_t EditHost::checked(Int3 at, std::uint32_t word) {
  if (word != 0 && proof_.isNeeded())
    if (auto problem = proof_.prove(at, word))
      store().fail(std::move(*problem));
  return proof_.kept(word);
}

void EditHost::keepOthers(unsigned level, Ref old) {
  std::vector<KeptCell> cells(store().kept(level).begin(), store().kept(level).end());
  std::unordered_set<std::uint32_t> changed;
  for (const KeptCell &kept : cells)
    changed.insert(kept.cell);
  if (old != 0)
    old_.cells(level, old, [&](std::uint64_t cell, std::uint32_t value) {
      if (!changed.contains(static_cast<std::uint32_t>(cell)))
        cells.push_back({static_cast<std::uint32_t>(cell), value});
    });
  store().drop(level);
  for (const KeptCell &kept : cells)
    if (kept.value != 0)
      store().keep(level, kept.cell, kept.value);
}

void EditHost::replaced(unsigned level, int layers, const Node &old, int log2Side, std::uint32_t word) {
  more_ += word == 0 ? 0 : std::int64_t{1} << 3 * log2Side;
  more_ -= static_cast<std::int64_t>(layers == 0 ? tally_.ofSubVolume(level, old.value)
                                                 : tally_.ofNode(level, layers, old));
}

void EditHost::fillTable() {
  construct::EditHost &table = edits_;
  table.self = this;
  table.effect = [](void *self, Voxel low, int log2Side, std::uint32_t *value) {
    const CubeChange change = serve<EditHost>(self, CubeChange{}, [&](EditHost &host) {
      return host.store().failure() ? CubeChange{} : host.changeOf({int3Of(low), log2Side});
    });
    *value = change.word;
    return change.kind == CubeChange::Keep  ? construct::Effect::Keep
           : change.kind == CubeChange::Set ? construct::Effect::Set
                                            : construct::Effect::Change;
  };
  table.voxel = [](void *self, Voxel at, std::uint32_t old) {
    return serve<EditHost>(self, old, [&](EditHost &host) { return host.voxel(int3Of(at), old); });
  };
  table.root = [](void *self, unsigned level, std::uint32_t old, Node *root) {
    *root = hostOf(self).old_.root(level, old);
  };
  table.children = [](void *self, unsigned level, const Node *node, Node *children) {
    hostOf(self).old_.children(level, *node,
                               [&](std::uint64_t index, const Node &child) { children[index] = child; });
  };
  table.read_cells = [](void *self, unsigned level, std::uint32_t old, std::uint32_t *cells) {
    serve<EditHost>(self, [&](EditHost &host) {
      host.old_.cells(level, old, [&](std::uint64_t cell, std::uint32_t value) { cells[cell] = value; });
    });
  };
  table.cell = [](void *self, unsigned level, std::uint32_t old, std::uint32_t cell) {
    return hostOf(self).old_.cell(level, old, cell);
  };
  table.keep_others = [](void *self, unsigned level, std::uint32_t old) {
    serve<EditHost>(self, [&](EditHost &host) { host.keepOthers(level, old); });
  };
  table.open = [](void *self, unsigned level, std::uint32_t old, construct::uint64_t count) {
    return serve<EditHost>(self, static_cast<std::uint32_t *>(nullptr),
                           [&](EditHost &host) { return host.words_.open(level, old, count); });
  };
  table.touch = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    serve<EditHost>(self, [&](EditHost &host) { host.words_.touch(level, words, count); });
  };
  table.close = [](void *self, unsigned level, bool shared) {
    return serve<EditHost>(self, Ref{1}, [&](EditHost &host) { return host.words_.close(level, shared); });
  };
  table.abandon = [](void *self, unsigned level) { hostOf(self).words_.abandon(level); };
  table.replaced = [](void *self, unsigned level, int layers, const Node *old, int log2Side,
                      std::uint32_t word) {
    serve<EditHost>(self, [&](EditHost &host) { host.replaced(level, layers, *old, log2Side, word); });
  };
}

} // namespace voxc
