// voxc_edit_entry.h: what the program that edits calls. The file that includes this has named `Volume`, its
// first level.
#pragma once

#include "voxc_edit.h"

// The bytes of a run of edits, which begins in such memory, of any contents.
extern "C" voxc::construct::uint64_t voxc_edit_bytes() { return sizeof(voxc::construct::Edit); }
extern "C" void voxc_edit_begin(void *memory, const voxc::construct::Host *host,
                                const voxc::construct::EditHost *edits) {
  new (memory) voxc::construct::Edit(*host, *edits);
}

// Does one edit of the volume to whose root `root` leads; returns what leads to the new one, 0 if there is no
// voxel.
extern "C" voxc::construct::uint32_t voxc_edit(void *run, voxc::construct::uint32_t root) {
  return Volume::edit(*static_cast<voxc::construct::Edit *>(run), root, {});
}
