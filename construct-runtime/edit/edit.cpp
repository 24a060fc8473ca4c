// edit.cpp: edits volumes of the format ${FORMAT}: what an edit touches is written anew, from the cells up to the root, and all
// else stays where it is.
#include "voxc_edit.h"

using namespace voxc::construct;

namespace {
${LEVELS}
} // namespace

// The bytes of a run of edits, which begins in such memory, of any contents.
extern "C" uint64_t voxc_edit_bytes() { return sizeof(Edit); }
extern "C" void voxc_edit_begin(void *memory, const Host *host, const EditHost *edits) { new (memory) Edit(*host, *edits); }

// Does one edit of the volume to whose root `root` leads; returns what leads to the new one, 0 if there is no voxel.
extern "C" uint32_t voxc_edit(void *run, uint32_t root) { return edit_level_1(*static_cast<Edit *>(run), root, {}); }
