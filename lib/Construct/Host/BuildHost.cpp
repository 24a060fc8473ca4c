// From the table of functions to the members of the host.
#include "BuildHost.h"

#include "Serve.h"

namespace voxc {
namespace {

using construct::Voxel;

Int3 cellOf(Voxel voxel) { return {voxel.x, voxel.y, voxel.z}; }

} // namespace

BuildHost::BuildHost(NodeStore &store) : store_(store) {
  construct::Host &table = table_;
  table.self = this;
  table.is_empty = [](void *self, Voxel low, int log2Side) {
    return serve<BuildHost>(self, true, [&](BuildHost &host) {
      return host.store_.failure() || host.isEmpty({cellOf(low), log2Side});
    });
  };
  table.read_brick = [](void *self, Voxel low, construct::Brick *brick) {
    const bool isRead = serve<BuildHost>(self, false, [&](BuildHost &host) {
      host.readBrick(cellOf(low), *brick);
      return true;
    });
    if (!isRead)
      *brick = {};
  };
  table.append = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    return serve<BuildHost>(self, Ref{1},
                            [&](BuildHost &host) { return host.store_.append(level, {words, count}); });
  };
  table.intern = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    return serve<BuildHost>(self, Ref{1},
                            [&](BuildHost &host) { return host.store_.intern(level, {words, count}); });
  };
  table.intern_leaf = [](void *self, unsigned level, std::uint32_t value) {
    return serve<BuildHost>(self, Ref{1},
                            [&](BuildHost &host) { return host.store_.internLeaf(level, value); });
  };
  table.find_leaf = [](void *self, unsigned level, std::uint32_t value) {
    return static_cast<BuildHost *>(self)->store_.leafAt(level, value);
  };
  table.announce = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    static_cast<BuildHost *>(self)->store_.announce(level, {words, count});
  };
  table.end_announcing = [](void *self, unsigned level) {
    static_cast<BuildHost *>(self)->store_.endAnnouncing(level);
  };
  table.put_value = [](void *self, std::uint32_t value) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.putValue(value); });
  };
  table.forget = [](void *self, unsigned level) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.store_.forget(level); });
  };
  table.allocate = [](void *self, unsigned level, construct::uint64_t count) {
    return serve<BuildHost>(self, static_cast<std::uint32_t *>(nullptr),
                            [&](BuildHost &host) { return host.store_.allocate(level, count); });
  };
  table.release = [](void *self, unsigned level) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.store_.release(level); });
  };
  table.keep = [](void *self, unsigned level, std::uint32_t cell, std::uint32_t value) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.store_.keep(level, cell, value); });
  };
  table.kept = [](void *self, unsigned level, construct::uint64_t *count) {
    const auto kept = static_cast<BuildHost *>(self)->store_.kept(level);
    *count = kept.size();
    return reinterpret_cast<const std::uint32_t *>(kept.data());
  };
  table.drop = [](void *self, unsigned level) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.store_.drop(level); });
  };
  table.pause = [](void *self, construct::uint64_t words) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.store_.pause(words); });
  };
  table.log2_part = -1;
  table.take_part = [](void *self, Voxel low, construct::Part *part) {
    *part = serve<BuildHost>(self, construct::Part{},
                             [&](BuildHost &host) { return host.takePart(cellOf(low)); });
  };
  table.finish_node = [](void *self, const construct::Node *node) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.finishNode(*node); });
  };
  table.finish_cell = [](void *self, const construct::PlacedCell *cell) {
    serve<BuildHost>(self, [&](BuildHost &host) { host.finishCell(*cell); });
  };
}

const construct::Host &BuildHost::interface() { return table_; }

} // namespace voxc
