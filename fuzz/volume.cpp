// Fuzzes .hvx files of all versions: checksums are put right, as a hostile file's would be.
#include "FuzzedFile.h"
#include "VolumeUse.h"
#include "WordMutator.h"

#include "Trace/CoarseTree.h"
#include "Volume/PageTable.h"
#include "Volume/VolumeFile.h"
#include "Volume/VolumeHead.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

namespace {

using namespace voxc;

/// Of the pages of a compressed file, as far as its tables can be read.
void putPageChecksumsRight(const Header &header, std::span<std::byte> bytes) {
  const auto tables = readPageTables(rowsOf(header, bytes), header.textEnd(), header.headBytes, bytes);
  if (!tables || !describeProblem(*tables, header.headBytes, bytes.size()).empty())
    return;
  std::byte *row = bytes.data() + header.textEnd();
  for (const StreamPages &stream : *tables)
    for (std::uint64_t page = 0; page < stream.rows.size(); ++page, row += sizeof(PageRow)) {
      Checksum checksum;
      const auto stored = stream.stored(bytes, page);
      checksum.add(stored.data(), stored.size());
      const PageRow right{stream.rows[page].end, checksum.digest()};
      std::memcpy(row, &right, sizeof right);
    }
}

void putChecksumsRight(std::span<std::byte> bytes) {
  const auto header = readHeader(bytes);
  if (!header)
    return;
  const bool isPaged = header->version == kPagedVersion;
  if (isPaged)
    putPageChecksumsRight(*header, bytes);
  Checksum checksum;
  addAllButItself(checksum, isPaged ? bytes.first(header->headBytes) : bytes);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + offsetof(Header, checksum), &digest, sizeof digest);
}

/// Every byte of every stream must be there.
void touch(const Volume &volume) {
  static volatile std::uint8_t sink = 0;
  for (const Stream &stream : volume.streams())
    for (const std::byte byte : stream.bytes)
      sink = sink ^ std::to_integer<std::uint8_t>(byte);
}

/// Coarse blocks that were found well-formed make a tree.
void useCoarse(const Volume &volume) {
  const auto coarse = coarseBlocksOf(volume);
  if (!coarse || !*coarse)
    return;
  const Int3 log2 = volume.format().log2Extent();
  const CoarseTree tree(**coarse, std::max({log2.x, log2.y, log2.z}));
  if (tree.blocks() != (*coarse)->blocks.size() || tree.layers() < 1)
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto *begin = reinterpret_cast<const std::byte *>(data);
  std::vector<std::byte> bytes(begin, begin + size);
  putChecksumsRight(bytes);
  if (const auto volume = readVolumeFile(bytes, nullptr, "a.hvx")) {
    touch(*volume);
    useCoarse(*volume);
    fuzz::decodeAll(*volume);
  }
  return 0;
}
