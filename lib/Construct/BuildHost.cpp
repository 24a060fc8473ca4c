// From the table of functions to the members of the host.
#include "BuildHost.h"

namespace voxc {
namespace {

using construct::Voxel;

Int3 cellOf(Voxel voxel) { return {voxel.x, voxel.y, voxel.z}; }
BuildHost &hostOf(void *self) { return *static_cast<BuildHost *>(self); }

} // namespace

BuildHost::BuildHost(NodeStore &store) : store_(store) {
  construct::Host &table = table_;
  table.self = this;
  table.is_empty = [](void *self, Voxel low, int log2Side) {
    return hostOf(self).store_.failure() || hostOf(self).isEmpty({cellOf(low), log2Side});
  };
  table.read_brick = [](void *self, Voxel low, std::uint32_t *voxels) {
    hostOf(self).readBrick(cellOf(low), voxels);
  };
  table.append = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    return hostOf(self).store_.append(level, {words, count});
  };
  table.intern = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    return hostOf(self).store_.intern(level, {words, count});
  };
  table.intern_leaf = [](void *self, unsigned level, std::uint32_t value) {
    return hostOf(self).store_.internLeaf(level, value);
  };
  table.put_value = [](void *self, std::uint32_t value) { hostOf(self).putValue(value); };
  table.forget = [](void *self, unsigned level) { hostOf(self).store_.forget(level); };
  table.allocate = [](void *self, unsigned level, construct::uint64_t count) {
    return hostOf(self).store_.allocate(level, count);
  };
  table.release = [](void *self, unsigned level) { hostOf(self).store_.release(level); };
  table.keep = [](void *self, unsigned level, std::uint32_t cell, std::uint32_t value) {
    hostOf(self).store_.keep(level, cell, value);
  };
  table.kept = [](void *self, unsigned level, construct::uint64_t *count) {
    const auto kept = hostOf(self).store_.kept(level);
    *count = kept.size();
    return reinterpret_cast<const std::uint32_t *>(kept.data());
  };
  table.drop = [](void *self, unsigned level) { hostOf(self).store_.drop(level); };
  table.pause = [](void *self, construct::uint64_t words) { hostOf(self).store_.pause(words); };
  table.log2_part = -1;
  table.take_part = [](void *self, Voxel low, construct::Part *part) {
    *part = hostOf(self).takePart(cellOf(low));
  };
  table.finish_node = [](void *self, const construct::Node *node) { hostOf(self).finishNode(*node); };
  table.finish_cell = [](void *self, const construct::PlacedCell *cell) { hostOf(self).finishCell(*cell); };
}

const construct::Host &BuildHost::interface() {
  table_.shared = store_.shared().data();
  return table_;
}

} // namespace voxc
