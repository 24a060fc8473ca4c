// Finding the first grid of a file.
#include "Input/NanoVdb/NanoVdbFile.h"

#include "Input/Dense/GzipReader.h"
#include "Source/NanoVdbLayout.h"

#include <cstring>
#include <string>
#include <utility>

namespace voxc {

namespace {

/// Takes a value off the front; false if there are too few bytes.
template <typename T> bool take(std::span<const std::byte> &bytes, T &value) {
  if (bytes.size() < sizeof value)
    return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes = bytes.subspan(sizeof value);
  return true;
}

Error cutShort(std::size_t bytes, std::uint64_t needed) {
  return Error::input("it is cut short: its first grid needs " + std::to_string(needed) +
                      " bytes, but there are " + std::to_string(bytes));
}

Expected<void> checkVersion(std::uint32_t version) {
  if (nanovdb::majorOf(version) == nanovdb::kMajorVersion)
    return {};
  return Error::input("it has version " + std::to_string(nanovdb::majorOf(version)) +
                      " of the layout; only 32 is read");
}

Expected<StoredGrid> inflate(std::span<const std::byte> rest, std::uint64_t gridBytes,
                             const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  std::uint64_t size = 0;
  if (!take(rest, size) || size > rest.size())
    return cutShort(rest.size(), size);
  GzipReader reader(rest.first(size), GzipReader::Wrapping::Zlib);
  auto inflated = reader.read(gridBytes, memory, progress);
  if (!inflated)
    return inflated.error();
  const std::span<const std::byte> bytes = (*inflated)->span();
  return StoredGrid{bytes, std::move(*inflated)};
}

} // namespace

Expected<StoredGrid> findNanoVdbGrid(std::shared_ptr<const WatchedFile> file,
                                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  std::span<const std::byte> rest = file->bytes();
  nanovdb::FileHead head;
  std::uint64_t magic = 0;
  if (rest.size() >= sizeof magic)
    std::memcpy(&magic, rest.data(), sizeof magic);
  if (magic == nanovdb::kMagicGrid)
    return StoredGrid{rest, std::move(file)};
  if ((magic != nanovdb::kMagic && magic != nanovdb::kMagicFile) || !take(rest, head))
    return Error::input("it does not begin as NanoVDB files do");
  if (auto checked = checkVersion(head.version); !checked)
    return checked.error();
  if (head.grids == 0)
    return Error::input("it has no grid");
  nanovdb::FileGrid first;
  for (std::uint32_t i = 0; i < head.grids; ++i) {
    nanovdb::FileGrid entry;
    if (!take(rest, entry) || entry.nameBytes > rest.size())
      return Error::input("it is cut short in the list of its " + std::to_string(head.grids) + " grids");
    rest = rest.subspan(entry.nameBytes);
    if (i == 0)
      first = entry;
  }
  if (head.codec == nanovdb::kBlosc)
    return Error::input("it is compressed by Blosc; write it without compression or with ZIP");
  if (head.codec != nanovdb::kUncompressed && head.codec != nanovdb::kZip)
    return Error::input("it is compressed in a way that is not known, number " + std::to_string(head.codec));
  Expected<StoredGrid> grid = Error::input("");
  if (head.codec == nanovdb::kZip)
    grid = inflate(rest, first.gridBytes, memory, progress);
  else if (first.gridBytes > rest.size())
    grid = cutShort(rest.size(), first.gridBytes);
  else
    grid = StoredGrid{rest.first(first.gridBytes), std::move(file)};
  if (grid)
    grid->others = head.grids - 1u;
  return grid;
}

} // namespace voxc
