// Fuzzes a journal of edits: as it is, and with right checksums, so that what stands behind them is read;
// then its edits on the voxels of a volume.
#include "Expect.h"

#include "Construct/Edit/JournalFormat.h"
#include "voxc/Source/Edit.h"
#include "voxc/Source/Sources.h"
#include "voxc/Source/VoxelChange.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <span>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr int kSide = 32;

/// What edits say of single voxels is what they say of cubes.
void apply(const std::vector<VoxelEdit> &edits) {
  for (std::size_t i = 0; i < edits.size() && i < 4; ++i) {
    const auto change = makeChange(edits[i]);
    for (std::uint64_t code = 0; code < 64; ++code) {
      const Cube cube = {mortonCell(code) * 8, 3};
      const CubeChange what = change->of(cube);
      for (std::uint64_t voxel = 0; voxel < 512 && what.kind != CubeChange::Some; ++voxel) {
        const std::uint32_t word = change->voxel(cube.low + mortonCell(voxel), 7);
        expect(word == (what.kind == CubeChange::Keep ? 7u : what.word));
      }
    }
  }
}

void read(std::span<const std::byte> bytes) {
  std::vector<VoxelEdit> edits;
  if (!journal::parseEdits(bytes, WorkingMemory::createDefault(), edits))
    return;
  std::erase_if(edits, [](const VoxelEdit &edit) { return !checkEdits({&edit, 1}, {kSide, kSide, kSide}); });
  apply(edits);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  if (const auto contents = journal::parse(bytes, "a.journal")) {
    expect(contents->end <= size);
    for (const journal::Record &record : contents->records)
      read(record.bytes);
  }
  read(bytes);
  return 0;
}
