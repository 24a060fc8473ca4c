// Finding a grid of a file.
#include "Input/NanoVdb/NanoVdbFile.h"

#include "Input/Dense/GzipReader.h"
#include "Input/NanoVdb/ValueKind.h"
#include "Source/NanoVdbLayout.h"

#include <algorithm>
#include <blosc.h>
#include <cstring>
#include <optional>
#include <string_view>
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

std::uint64_t magicOf(std::span<const std::byte> bytes) {
  std::uint64_t magic = 0;
  return take(bytes, magic) ? magic : 0;
}

/// A text up to its 0.
std::string textOf(const char *text, std::size_t most) {
  const std::string_view all(text, most);
  return std::string(all.substr(0, all.find('\0')));
}

Error cutShort(std::size_t bytes, std::uint64_t needed) {
  return Error::input("it is cut short: its grid needs " + std::to_string(needed) + " bytes, but there are " +
                      std::to_string(bytes));
}

Expected<void> checkVersion(std::uint32_t version) {
  if (nanovdb::majorOf(version) == nanovdb::kMajorVersion)
    return {};
  return Error::input("it has version " + std::to_string(nanovdb::majorOf(version)) +
                      " of the layout; only 32 is read");
}

/// Grids one after the other as they lie in memory, without a head around them.
std::vector<ListedGrid> listBareGrids(std::span<const std::byte> bytes) {
  std::vector<ListedGrid> grids;
  nanovdb::Grid head;
  for (auto rest = bytes; magicOf(rest) == nanovdb::kMagicGrid && rest.size() >= sizeof head;) {
    std::memcpy(static_cast<void *>(&head), rest.data(), sizeof head);
    const std::uint64_t size =
        head.bytes >= sizeof head ? std::min<std::uint64_t>(head.bytes, rest.size()) : rest.size();
    grids.push_back(
        {textOf(head.name.data(), head.name.size()), head.type, size, nanovdb::kUncompressed, rest});
    rest = rest.subspan(size);
  }
  if (grids.empty())
    grids.push_back({"", 0, bytes.size(), nanovdb::kUncompressed, bytes});
  return grids;
}

/// Bytes in the file of a grid whose data begin here; nothing if it is cut short.
std::optional<std::uint64_t> storedBytes(const nanovdb::FileGrid &entry, std::uint16_t codec,
                                         std::span<const std::byte> data) {
  std::uint64_t size = 0;
  if (codec == nanovdb::kUncompressed)
    size = entry.gridBytes;
  else if (codec == nanovdb::kZip && (!take(data, size) || size > data.size()))
    return std::nullopt;
  else
    size = codec == nanovdb::kZip ? size + sizeof size : entry.fileBytes;
  return size;
}

/// Reads a segment off the front of `rest`.
Expected<void> addSegment(std::span<const std::byte> &rest, std::vector<ListedGrid> &grids) {
  nanovdb::FileHead head;
  if (!take(rest, head))
    return Error::input("it does not begin as NanoVDB files do");
  VOXC_TRY(checkVersion(head.version));
  if (head.grids == 0)
    return Error::input("it has no grid");
  std::vector<nanovdb::FileGrid> entries;
  for (std::uint32_t i = 0; i < head.grids; ++i) {
    nanovdb::FileGrid entry;
    if (!take(rest, entry) || entry.nameBytes > rest.size())
      return Error::input("it is cut short in the list of its " + std::to_string(head.grids) + " grids");
    const auto *const name = reinterpret_cast<const char *>(rest.data());
    grids.push_back({textOf(name, entry.nameBytes), entry.type, entry.gridBytes, head.codec, {}});
    entries.push_back(entry);
    rest = rest.subspan(entry.nameBytes);
  }
  const std::size_t first = grids.size() - entries.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    grids[first + i].stored = rest;
    const auto size = storedBytes(entries[i], head.codec, rest);
    // What is cut short matters if it is the one that is read.
    rest = rest.subspan(std::min<std::uint64_t>(size.value_or(rest.size()), rest.size()));
  }
  return {};
}

Expected<StoredGrid> inflate(const ListedGrid &grid, const std::shared_ptr<WorkingMemory> &memory,
                             const Progress &progress) {
  std::span<const std::byte> rest = grid.stored;
  std::uint64_t size = 0;
  if (!take(rest, size) || size > rest.size())
    return cutShort(rest.size(), size);
  GzipReader reader(rest.first(size), GzipReader::Wrapping::Zlib);
  auto inflated = VOXC_TRY(reader.read(grid.bytes, memory, progress));
  const std::span<const std::byte> bytes = inflated->span();
  return StoredGrid{bytes, std::move(inflated), {}, {}};
}

/// A grid in chunks of at most a gigabyte, each with its size before it.
Expected<StoredGrid> inflateBlosc(const ListedGrid &grid, const std::shared_ptr<WorkingMemory> &memory,
                                  const Progress &progress) {
  constexpr std::uint64_t kChunk = std::uint64_t{1} << 30;
  constexpr std::uint64_t kMostPerByte = 1 << 15; // More than any of its codecs makes of a byte.
  auto inflated = std::make_shared<InflatedBytes>(memory);
  std::span<const std::byte> rest = grid.stored;
  for (std::uint64_t done = 0; done < grid.bytes;) {
    if (progress.stopped())
      return Error::interrupted();
    const std::uint64_t chunk = std::min(kChunk, grid.bytes - done);
    std::uint64_t size = 0;
    if (!take(rest, size) || size > rest.size())
      return cutShort(rest.size(), size);
    std::size_t found = 0;
    if (blosc_cbuffer_validate(rest.data(), size, &found) != 0 || found != chunk ||
        chunk / kMostPerByte > size)
      return Error::input("its data that Blosc compressed is damaged, or is not as large as its head says");
    VOXC_TRY(inflated->resize(done + chunk));
    if (blosc_decompress_ctx(rest.data(), inflated->data() + done, chunk, 1) != static_cast<int>(chunk))
      return Error::input("its data that Blosc compressed is damaged");
    rest = rest.subspan(size);
    done += chunk;
  }
  const std::span<const std::byte> bytes = std::as_const(*inflated).span();
  return StoredGrid{bytes, std::move(inflated), {}, {}};
}

std::string described(const ListedGrid &grid) {
  return (grid.name.empty() ? "one without a name" : grid.name) + " (" + nameOfType(grid.type) + ")";
}

std::string listed(const std::vector<std::string> &names) {
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Which grid is asked for.
Expected<std::size_t> choose(const std::vector<ListedGrid> &grids, const std::string &name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    if (name.empty() ? findValueKind(grids[i].type) != nullptr : grids[i].name == name)
      return i;
    names.push_back(described(grids[i]));
  }
  // Its reader says of a single one what it is.
  if (name.empty() && grids.size() == 1)
    return std::size_t{0};
  return Error::input(
      (name.empty() ? std::string("none of its grids can be a shape") : "it has no grid '" + name + "'") +
      "; there are " + listed(names));
}

} // namespace

Expected<std::vector<ListedGrid>> listNanoVdbGrids(std::span<const std::byte> bytes) {
  if (magicOf(bytes) == nanovdb::kMagicGrid)
    return listBareGrids(bytes);
  std::vector<ListedGrid> grids;
  for (auto rest = bytes; grids.empty() || !rest.empty();) {
    const std::uint64_t magic = magicOf(rest);
    if (magic != nanovdb::kMagic && magic != nanovdb::kMagicFile) {
      if (grids.empty())
        return Error::input("it does not begin as NanoVDB files do");
      break;
    }
    VOXC_TRY(addSegment(rest, grids));
  }
  return grids;
}

Expected<StoredGrid> findNanoVdbGrid(std::shared_ptr<const WatchedFile> file, const std::string &name,
                                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  const auto grids = VOXC_TRY(listNanoVdbGrids(file->bytes()));
  const auto chosen = VOXC_TRY(choose(grids, name));
  const ListedGrid &grid = grids[chosen];
  Expected<StoredGrid> stored =
      Error::input("it is compressed in a way that is not known, number " + std::to_string(grid.codec));
  if (grid.codec == nanovdb::kBlosc)
    stored = inflateBlosc(grid, memory, progress);
  else if (grid.codec == nanovdb::kZip)
    stored = inflate(grid, memory, progress);
  else if (grid.codec == nanovdb::kUncompressed && grid.bytes > grid.stored.size())
    stored = cutShort(grid.stored.size(), grid.bytes);
  else if (grid.codec == nanovdb::kUncompressed)
    stored = StoredGrid{grid.stored.first(grid.bytes), std::move(file), {}, {}};
  if (!stored)
    return stored;
  stored->name = grid.name;
  for (std::size_t i = 0; i < grids.size(); ++i)
    if (i != chosen)
      stored->others.push_back(described(grids[i]));
  return stored;
}

} // namespace voxc
