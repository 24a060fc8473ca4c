// Editable volumes in C.
#include "C/BuildOptions.h"
#include "C/Handles.h"
#include "voxc/Construct/EditableVolume.h"

#include <voxc-c/voxc.h>

#include <algorithm>
#include <span>
#include <vector>

using namespace voxc;
using namespace voxc::c;

struct voxc_editable {
  EditableVolume volume;
  mutable const char *running = nullptr; ///< What calls functions of the caller, as "an edit"; null: nothing.
  EditableVolume::Snapshot before = {};  ///< The state that an edit which calls them began with.
};

namespace {

constexpr const char *kEdit = "an edit";

Int3 int3(const int32_t values[3]) { return {values[0], values[1], values[2]}; }

EditableVolume::Snapshot snapshotOf(voxc_snapshot snapshot) {
  return {static_cast<Ref>(snapshot.root), snapshot.voxels};
}

/// Marks what is running, for functions of the caller that would begin another within it.
class Running {
public:
  Running(const voxc_editable *editable, const char *what) : editable_(editable) { editable->running = what; }
  ~Running() { editable_->running = nullptr; }
  Running(const Running &) = delete;
  Running &operator=(const Running &) = delete;

private:
  const voxc_editable *editable_;
};

Expected<void> checkIdle(const voxc_editable *editable) {
  if (!editable->running)
    return {};
  return Error::usage(
      std::string(editable->running) +
      " of this volume is running, whose function must not edit, compact, follow or frame it");
}

Expected<void> edit(voxc_editable *editable, const std::unique_ptr<VoxelChange> &change) {
  VOXC_TRY(checkIdle(editable));
  const Running running(editable, kEdit);
  VOXC_TRY(editable->volume.apply(*change));
  return {};
}

} // namespace

voxc_error *voxc_editable_create(const voxc_volume *volume, voxc_editable **editable) {
  return guarded([&]() -> Expected<void> {
    auto made = VOXC_TRY(EditableVolume::create(*volume->volume));
    *editable = new voxc_editable{std::move(made)};
    return {};
  });
}

void voxc_editable_free(voxc_editable *editable) { delete editable; }

voxc_error *voxc_editable_set_box(voxc_editable *editable, const int32_t low[3], const int32_t size[3],
                                  uint32_t word) {
  return guarded([&] { return edit(editable, makeBoxChange(int3(low), int3(size), word)); });
}

voxc_error *voxc_editable_set_sphere(voxc_editable *editable, const int32_t centre[3], int32_t radius,
                                     uint32_t word) {
  return guarded([&]() -> Expected<void> {
    if (radius < 0 || radius > kMostSphereRadius)
      return Error::usage("the radius of a sphere is 0 to " + std::to_string(kMostSphereRadius) + ", not " +
                          std::to_string(radius));
    return edit(editable, makeSphereChange(int3(centre), radius, word));
  });
}

voxc_error *voxc_editable_set_voxels(voxc_editable *editable, const int32_t *places, const uint32_t *words,
                                     uint64_t count) {
  return guarded([&]() -> Expected<void> {
    std::vector<VoxelWord> voxels;
    voxels.reserve(count);
    for (uint64_t i = 0; i < count; ++i) {
      const Int3 at = int3(places + 3 * i);
      if (((at.x | at.y | at.z) >> kMaxLog2Extent) != 0)
        return Error::usage("voxel " + std::to_string(i) + " of the list lies outside of all volumes");
      voxels.push_back({at, words[i]});
    }
    return edit(editable, makeListChange(voxels));
  });
}

voxc_error *voxc_editable_paste(voxc_editable *editable, const voxc_volume *volume, const int32_t low[3]) {
  return guarded([&] { return edit(editable, makePasteChange(volume->volume, int3(low))); });
}

voxc_error *voxc_editable_apply(voxc_editable *editable, const int32_t low[3], const int32_t size[3],
                                uint32_t (*function)(void *user, int32_t x, int32_t y, int32_t z,
                                                     uint32_t word),
                                void *user) {
  return guarded([&] {
    if (!editable->running)
      editable->before = editable->volume.snapshot();
    const auto voxel = [&](Int3 at, std::uint32_t word) { return function(user, at.x, at.y, at.z, word); };
    return edit(editable, makeFunctionChange(int3(low), int3(size), voxel));
  });
}

voxc_snapshot voxc_editable_snapshot(voxc_editable *editable) {
  const bool isEdited = editable->running == kEdit;
  const auto snapshot = isEdited ? editable->before : editable->volume.snapshot();
  return {snapshot.root, snapshot.voxels};
}

void voxc_editable_restore(voxc_editable *editable, voxc_snapshot snapshot) {
  if (!editable->running)
    editable->volume.restore(snapshotOf(snapshot));
}

voxc_error *voxc_editable_view(voxc_editable *editable, voxc_snapshot snapshot, voxc_volume **volume) {
  return guarded([&] { return handOver(editable->volume.view(snapshotOf(snapshot)), volume); });
}

uint64_t voxc_editable_frames(const voxc_editable *editable, voxc_snapshot *frames, uint64_t most) {
  const auto states = editable->volume.frames();
  for (std::size_t i = 0; i < std::min<std::size_t>(most, states.size()); ++i)
    frames[i] = {states[i].root, states[i].voxels};
  return states.size();
}

voxc_error *voxc_editable_framed(voxc_editable *editable, const voxc_snapshot *frames, uint64_t count,
                                 voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    if (count == 0)
      return Error::usage("a volume of no frames was asked for; name one state at least");
    VOXC_TRY(checkIdle(editable));
    std::vector<EditableVolume::Snapshot> states;
    for (const voxc_snapshot &frame : std::span(frames, count))
      states.push_back(snapshotOf(frame));
    return handOver(editable->volume.framed(states), volume);
  });
}

uint64_t voxc_editable_voxels(const voxc_editable *editable) { return editable->volume.voxels(); }
uint64_t voxc_editable_words(const voxc_editable *editable) { return editable->volume.words(); }
int voxc_editable_wants_compaction(const voxc_editable *editable) {
  return editable->volume.wantsCompaction() ? 1 : 0;
}

voxc_error *voxc_editable_compact(const voxc_editable *editable, const voxc_build_options *options,
                                  voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    VOXC_TRY(checkIdle(editable));
    const Running running(editable, "a compaction");
    const CallersProgress progress(given.progress);
    BuildOptions building = buildOptionsOf(given, progress.get());
    building.memory = memoryOf(given);
    auto built = VOXC_TRY(editable->volume.compact(building));
    return handOver(std::move(built.volume), volume);
  });
}

voxc_error *voxc_tracer_follow(voxc_tracer *tracer, voxc_editable *editable, uint64_t *copied_bytes) {
  return guarded([&]() -> Expected<void> {
    VOXC_TRY(checkIdle(editable));
    VOXC_TRY(c::checkIdle(*tracer));
    const auto volume = editable->volume.volume();
    VOXC_TRY(checkTakes(*tracer, *volume));
    const std::vector<WordRange> changes = editable->volume.takeChanges();
    const WordRange all{0, volume->words().size()};
    const auto followed =
        tracer->tracer->follow(*volume, tracer->isOther ? std::span(&all, 1) : std::span(changes));
    if (!followed) {
      editable->volume.putBackChanges(changes); // A tracer in place of this one lacks them.
      return followed.error();
    }
    tracer->volume = volume;
    tracer->follows = true;
    if (volume->words()[0] != 0) // One that is empty has its head alone copied.
      tracer->isOther = false;
    if (copied_bytes)
      *copied_bytes = followed->copiedBytes;
    return {};
  });
}
