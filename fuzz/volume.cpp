// Fuzzes .hvx files of all versions, with right checksums.
#include "RightChecksums.h"
#include "VolumeUse.h"
#include "WordMutator.h"

#include "Trace/Paging/CoarseTree.h"
#include "Volume/VolumeFile.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace {

/// Every byte of every stream must be there.
void touch(const voxc::Volume &volume) {
  static volatile std::uint8_t sink = 0;
  for (const voxc::Stream &stream : volume.streams())
    for (const std::byte byte : stream.bytes)
      sink = sink ^ std::to_integer<std::uint8_t>(byte);
}

/// Coarse blocks that were found well-formed make a tree.
void useCoarse(const voxc::Volume &volume) {
  const auto coarse = voxc::coarseBlocksOf(volume);
  if (!coarse || !*coarse)
    return;
  const voxc::Int3 log2 = volume.format().log2Extent();
  const voxc::CoarseTree tree(**coarse, std::max({log2.x, log2.y, log2.z}));
  if (tree.blocks() != (*coarse)->blocks.size() || tree.layers() < 1)
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = voxc::fuzz::withRightChecksums(data, size);
  if (const auto volume = voxc::readVolumeFile(bytes, nullptr, "a.hvx")) {
    touch(*volume);
    useCoarse(*volume);
    voxc::fuzz::decodeAll(*volume);
  }
  return 0;
}
