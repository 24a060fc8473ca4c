// The chunks of MagicaVoxel files, each with a reader of its own in a table.
#include "Input/MagicaVoxel/VoxFile.h"

#include "Input/MagicaVoxel/VoxPalette.h"

#include <charconv>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace voxc {

namespace {

/// Reads little-endian words and texts from the front of bytes. What is not there is 0 and makes it fail.
class Cursor {
public:
  explicit Cursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool failed() const { return failed_; }
  std::size_t size() const { return bytes_.size(); }

  std::span<const std::byte> take(std::uint64_t count) {
    if (count > bytes_.size()) {
      failed_ = true;
      bytes_ = {};
      return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

  std::uint32_t word() {
    const auto bytes = take(4);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value |= std::to_integer<std::uint32_t>(bytes[i]) << 8 * i;
    return value;
  }

  std::string_view text() {
    const auto bytes = take(word());
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
  }

  /// A count of things that take `bytesEach` or more: 0 if they cannot all be there.
  std::uint32_t count(std::uint32_t bytesEach) {
    const std::uint32_t value = word();
    if (value <= bytes_.size() / bytesEach)
      return value;
    failed_ = true;
    return 0;
  }

private:
  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

/// Calls `visit(key, value)` for each pair of a dictionary.
template <typename Visit> void readDictionary(Cursor &cursor, Visit visit) {
  for (std::uint32_t pairs = cursor.count(8); pairs > 0 && !cursor.failed(); --pairs) {
    const std::string_view key = cursor.text();
    visit(key, cursor.text());
  }
}

/// A dictionary of which only "_hidden" matters.
bool readHidden(Cursor &cursor) {
  bool isHidden = false;
  readDictionary(cursor, [&](std::string_view key, std::string_view value) {
    isHidden = isHidden || (key == "_hidden" && value == "1");
  });
  return isHidden;
}

/// A whole number at the front of `text`, which is taken off; 0 if there is none.
std::int32_t takeInteger(std::string_view &text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::int32_t value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
  return value;
}

/// One frame of a transform.
struct Frame {
  std::int32_t time = 0;
  unsigned rotation = 4; ///< No rotation.
  Long3 translation{};
};

Frame readFrame(Cursor &cursor) {
  Frame frame;
  readDictionary(cursor, [&](std::string_view key, std::string_view value) {
    if (key == "_f")
      frame.time = takeInteger(value);
    else if (key == "_r")
      frame.rotation = static_cast<unsigned>(takeInteger(value));
    else if (key == "_t")
      for (std::int64_t &coordinate : frame.translation)
        coordinate = takeInteger(value);
  });
  return frame;
}

/// What is read so far.
struct Reading {
  VoxFile file;
  Long3 size{-1, -1, -1}; ///< Of the next model.
};

Expected<void> addNode(VoxFile &file, std::uint32_t number, VoxNode &&node) {
  if (file.nodes.try_emplace(number, std::move(node)).second)
    return {};
  return Error::input("two nodes have the number " + std::to_string(number));
}

Expected<void> readSize(Cursor &cursor, Reading &reading) {
  for (std::int64_t &size : reading.size)
    size = cursor.word();
  return {};
}

Expected<void> readVoxels(Cursor &cursor, Reading &reading) {
  if (reading.size[0] < 0)
    return Error::input("it has voxels without a size");
  const std::uint32_t count = cursor.count(4);
  const auto voxels = cursor.take(std::uint64_t{4} * count);
  // A voxel's coordinates are bytes.
  for (const std::int64_t size : reading.size)
    if (size > 256)
      return Error::input("a model has " + std::to_string(size) + " cells on an axis; there may be 256");
  reading.file.models.push_back({std::exchange(reading.size, {-1, -1, -1}), voxels});
  return {};
}

Expected<void> readColours(Cursor &cursor, Reading &reading) {
  for (std::size_t i = 1; i < 256; ++i)
    reading.file.colours[i] = cursor.word();
  return {};
}

Expected<void> readTransform(Cursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Transform;
  const std::uint32_t number = cursor.word();
  node.isHidden = readHidden(cursor);
  node.children = {cursor.word()};
  cursor.word();
  node.layer = static_cast<std::int32_t>(cursor.word());
  Frame first{std::numeric_limits<std::int32_t>::max()};
  for (std::uint32_t frames = cursor.count(4); frames > 0 && !cursor.failed(); --frames)
    if (const Frame frame = readFrame(cursor); frame.time < first.time)
      first = frame;
  const auto placement = Placement::fromByte(first.rotation);
  if (!placement)
    return Error::input("node " + std::to_string(number) + " has the rotation " +
                        std::to_string(first.rotation) + ", which is none");
  node.placement = *placement;
  node.placement.setTranslation(first.translation);
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readGroup(Cursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Group;
  const std::uint32_t number = cursor.word();
  node.isHidden = readHidden(cursor);
  node.children.resize(cursor.count(4));
  for (std::uint32_t &child : node.children)
    child = cursor.word();
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readShape(Cursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Shape;
  const std::uint32_t number = cursor.word();
  node.isHidden = readHidden(cursor);
  const std::uint32_t models = cursor.count(8);
  if (models == 0 && !cursor.failed())
    return Error::input("the shape " + std::to_string(number) + " has no model");
  std::int32_t first = std::numeric_limits<std::int32_t>::max();
  for (std::uint32_t i = 0; i < models && !cursor.failed(); ++i) {
    const std::uint32_t model = cursor.word();
    if (const Frame frame = readFrame(cursor); frame.time < first) {
      first = frame.time;
      node.model = model;
    }
  }
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readLayer(Cursor &cursor, Reading &reading) {
  const auto number = static_cast<std::int32_t>(cursor.word());
  if (readHidden(cursor))
    reading.file.hiddenLayers.insert(number);
  return {};
}

struct ChunkKind {
  std::string_view name;
  Expected<void> (*read)(Cursor &cursor, Reading &reading);
};

/// Chunks of other names say how a scene is lit, seen or sorted for display, which changes no voxel.
constexpr std::array<ChunkKind, 7> kChunks{{{"SIZE", readSize},
                                            {"XYZI", readVoxels},
                                            {"RGBA", readColours},
                                            {"nTRN", readTransform},
                                            {"nGRP", readGroup},
                                            {"nSHP", readShape},
                                            {"LAYR", readLayer}}};

Expected<void> readChunk(std::string_view name, std::span<const std::byte> content, Reading &reading) {
  for (const ChunkKind &kind : kChunks) {
    if (kind.name != name)
      continue;
    Cursor cursor(content);
    auto read = kind.read(cursor, reading);
    if (cursor.failed())
      return Error::input("a chunk " + std::string(name) + " speaks of more than its " +
                          std::to_string(content.size()) + " bytes hold");
    return read;
  }
  return {};
}

std::string_view takeName(Cursor &cursor) {
  const auto bytes = cursor.take(4);
  return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

} // namespace

Expected<VoxFile> readVoxFile(std::span<const std::byte> bytes) {
  Cursor cursor(bytes);
  if (takeName(cursor) != "VOX ")
    return Error::input("it does not begin with 'VOX '");
  cursor.word(); // Versions differ in chunks that are left alone.
  if (takeName(cursor) != "MAIN")
    return Error::input("its first chunk is not MAIN");
  const std::uint32_t mainBytes = cursor.word();
  cursor.word(); // Chunks follow up to the end of the file.
  cursor.take(mainBytes);
  Reading reading;
  reading.file.colours = defaultVoxPalette();
  while (!cursor.failed() && cursor.size() > 0) {
    const std::string_view name = takeName(cursor);
    const std::uint32_t content = cursor.word();
    const std::uint32_t children = cursor.word();
    const auto chunk = cursor.take(content);
    cursor.take(children);
    if (!cursor.failed())
      if (auto read = readChunk(name, chunk, reading); !read)
        return read.error();
  }
  if (cursor.failed())
    return Error::input("a chunk reaches over its end");
  if (reading.file.models.empty())
    return Error::input("it has no model");
  return std::move(reading.file);
}

} // namespace voxc
