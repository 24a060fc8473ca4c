// The chunks of MagicaVoxel files, each with a reader of its own in a table.
#include "Input/MagicaVoxel/VoxFile.h"

#include "Input/MagicaVoxel/VoxCursor.h"
#include "Input/MagicaVoxel/VoxKeys.h"
#include "Input/MagicaVoxel/VoxMaterial.h"
#include "Input/MagicaVoxel/VoxPalette.h"
#include "Support/Text.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace voxc {

namespace {

/// Notes a name, unless there are many already: a file could have any number of them.
void note(std::set<std::string> &names, std::string_view name) {
  constexpr std::size_t kMostNamed = 8, kLongest = 32;
  if (names.size() < kMostNamed)
    names.emplace(name.substr(0, kLongest));
}

/// What a node or a layer says of itself.
struct VoxAttributes {
  bool isHidden = false;
  bool loops = false; ///< Its keys.
};

/// Of what is not used, what says something is noted.
VoxAttributes readAttributes(VoxCursor &cursor, VoxFile &file) {
  VoxAttributes attributes;
  readDictionary(cursor, [&](std::string_view key, std::string_view value) {
    if (key == "_hidden")
      attributes.isHidden = attributes.isHidden || value == "1";
    else if (key == "_loop")
      attributes.loops = attributes.loops || value == "1";
    else if (!value.empty())
      note(file.unused, key);
  });
  return attributes;
}

/// The next whole number of `text`, which is taken off. A '+' may stand before it.
std::optional<std::int32_t> takeInteger(std::string_view &text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.starts_with('+') && !text.starts_with("+-"))
    text.remove_prefix(1);
  std::int32_t value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc())
    return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
  return value;
}

/// Whole numbers with blanks between them, as many as `numbers` has; false if `text` is anything else.
bool readIntegers(std::string_view text, std::span<std::int64_t> numbers) {
  for (std::int64_t &number : numbers) {
    const auto value = takeInteger(text);
    if (!value || (!text.empty() && text.front() != ' '))
      return false;
    number = *value;
  }
  return text.find_first_not_of(' ') == std::string_view::npos;
}

Error wrongKey(std::uint32_t node, std::string_view what, std::string_view text, std::string_view right) {
  constexpr std::size_t kLongest = 32;
  return Error::input("node " + std::to_string(node) + " has the " + std::string(what) + " '" +
                      printable(text.substr(0, kLongest)) + "', which is no " + std::string(right));
}

/// A key of the node with this number.
Expected<VoxKey> readKey(VoxCursor &cursor, std::uint32_t node) {
  VoxKey key;
  std::int64_t rotation = key.rotation;
  std::optional<Error> problem;
  readDictionary(cursor, [&](std::string_view name, std::string_view value) {
    if (name == "_f" && !readIntegers(value, {&key.time, 1}))
      problem = wrongKey(node, "time", value, "whole number of 32 bits");
    else if (name == "_r" && (!readIntegers(value, {&rotation, 1}) || rotation < 0))
      problem = wrongKey(node, "rotation", value, "whole number from 0 up");
    else if (name == "_t" && !readIntegers(value, key.translation))
      problem = wrongKey(node, "place", value, "three whole numbers of 32 bits");
  });
  key.rotation = static_cast<unsigned>(rotation);
  if (problem && !cursor.failed())
    return *problem;
  return key;
}

/// Error: a node has more keys than there are frames.
Expected<void> checkKeys(std::uint32_t count, std::uint32_t node) {
  if (count <= kMostVoxFrames)
    return {};
  return Error::input("node " + std::to_string(node) + " has " + std::to_string(count) +
                      " keys; there may be " + std::to_string(kMostVoxFrames));
}

/// What is read so far.
struct Reading {
  VoxFile file;
  std::int32_t frame = 0; ///< That is asked for.
  Long3 size{-1, -1, -1}; ///< Of the next model.
};

/// The key of a node for the frame that is asked for.
VoxKey chooseKey(Reading &reading, std::vector<VoxKey> keys, bool loop) {
  reading.file.frames = std::max(reading.file.frames, framesOf(keys));
  return keyAt(std::move(keys), loop, reading.frame);
}

Expected<void> addNode(VoxFile &file, std::uint32_t number, VoxNode &&node) {
  if (file.nodes.try_emplace(number, std::move(node)).second)
    return {};
  return Error::input("two nodes have the number " + std::to_string(number));
}

Expected<void> readSize(VoxCursor &cursor, Reading &reading) {
  for (std::int64_t &size : reading.size)
    size = cursor.word();
  return {};
}

Expected<void> readVoxels(VoxCursor &cursor, Reading &reading) {
  if (reading.size[0] < 0)
    return Error::input("it has voxels without a size");
  const std::uint32_t count = cursor.count(4);
  const auto voxels = cursor.take(std::uint64_t{4} * count);
  reading.file.bytesBehind += cursor.size();
  // A voxel's coordinates are bytes.
  for (const std::int64_t size : reading.size)
    if (size > 256)
      return Error::input("a model has " + std::to_string(size) + " cells on an axis; there may be 256");
  reading.file.models.push_back({std::exchange(reading.size, {-1, -1, -1}), voxels});
  return {};
}

Expected<void> readColours(VoxCursor &cursor, Reading &reading) {
  for (std::size_t i = 1; i < 256; ++i)
    reading.file.colours[i] = cursor.word();
  return {};
}

Expected<void> readTransform(VoxCursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Transform;
  const std::uint32_t number = cursor.word();
  const VoxAttributes attributes = readAttributes(cursor, reading.file);
  node.isHidden = attributes.isHidden;
  node.children = {cursor.word()};
  cursor.word();
  node.layer = static_cast<std::int32_t>(cursor.word());
  const std::uint32_t count = cursor.count(4);
  VOXC_TRY(checkKeys(count, number));
  std::vector<VoxKey> keys;
  for (std::uint32_t left = count; left > 0 && !cursor.failed(); --left)
    keys.push_back(VOXC_TRY(readKey(cursor, number)));
  const VoxKey chosen = chooseKey(reading, std::move(keys), attributes.loops);
  const auto placement = Placement::fromByte(chosen.rotation);
  if (!placement)
    return Error::input("node " + std::to_string(number) + " has the rotation " +
                        std::to_string(chosen.rotation) + ", which is none");
  node.placement = *placement;
  node.placement.setTranslation(chosen.translation);
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readGroup(VoxCursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Group;
  const std::uint32_t number = cursor.word();
  node.isHidden = readAttributes(cursor, reading.file).isHidden;
  node.children.resize(cursor.count(4));
  for (std::uint32_t &child : node.children)
    child = cursor.word();
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readShape(VoxCursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Shape;
  const std::uint32_t number = cursor.word();
  const VoxAttributes attributes = readAttributes(cursor, reading.file);
  node.isHidden = attributes.isHidden;
  const std::uint32_t models = cursor.count(8);
  if (models == 0 && !cursor.failed())
    return Error::input("the shape " + std::to_string(number) + " has no model");
  VOXC_TRY(checkKeys(models, number));
  std::vector<VoxKey> keys;
  for (std::uint32_t i = 0; i < models && !cursor.failed(); ++i) {
    const std::uint32_t model = cursor.word();
    keys.push_back(VOXC_TRY(readKey(cursor, number)));
    keys.back().model = model;
  }
  node.model = chooseKey(reading, std::move(keys), attributes.loops).model;
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readLayer(VoxCursor &cursor, Reading &reading) {
  const auto number = static_cast<std::int32_t>(cursor.word());
  if (readAttributes(cursor, reading.file).isHidden)
    reading.file.hiddenLayers.insert(number);
  return {};
}

/// A material of the colour of its number, of which 256 stands for 0.
Expected<void> readMaterial(VoxCursor &cursor, Reading &reading) {
  const std::uint32_t number = cursor.word() % 256;
  VoxMaterial material;
  readDictionary(cursor, [&](std::string_view key, std::string_view value) { material.read(key, value); });
  material.keep(reading.file, number);
  return {};
}

/// A material as files had them at first: a type, its share, and of seven properties those that a bit says
/// are there, of which roughness is the second.
Expected<void> readOldMaterial(VoxCursor &cursor, Reading &reading) {
  constexpr std::array<std::string_view, 4> kTypes{"_diffuse", "_metal", "_glass", "_emit"};
  constexpr unsigned kProperties = 7, kRoughness = 1;
  const std::uint32_t number = cursor.word() % 256, type = cursor.word();
  VoxMaterial material;
  if (type < kTypes.size())
    material.read("_type", kTypes[type]);
  const auto share = [&] { return std::to_string(std::bit_cast<float>(cursor.word())); };
  material.read("_weight", share());
  const std::uint32_t bits = cursor.word();
  for (unsigned i = 0; i < kProperties; ++i)
    if ((bits >> i & 1) != 0)
      if (const std::string value = share(); i == kRoughness)
        material.read("_rough", value);
  material.keep(reading.file, number);
  return {};
}

/// How many models there are, which their chunks say too.
Expected<void> passOver(VoxCursor &, Reading &) { return {}; }

struct ChunkKind {
  std::string_view name;
  /// None for what says how a scene is lit, seen or sorted for display.
  Expected<void> (*read)(VoxCursor &cursor, Reading &reading);
};

constexpr std::array<ChunkKind, 14> kChunks{{{"SIZE", readSize},
                                             {"XYZI", readVoxels},
                                             {"RGBA", readColours},
                                             {"nTRN", readTransform},
                                             {"nGRP", readGroup},
                                             {"nSHP", readShape},
                                             {"LAYR", readLayer},
                                             {"MATL", readMaterial},
                                             {"MATT", readOldMaterial},
                                             {"PACK", passOver},
                                             {"IMAP", nullptr},
                                             {"NOTE", nullptr},
                                             {"rCAM", nullptr},
                                             {"rOBJ", nullptr}}};

Expected<void> readChunk(std::string_view name, std::span<const std::byte> content, Reading &reading) {
  for (const ChunkKind &kind : kChunks) {
    if (kind.name != name)
      continue;
    if (kind.read == nullptr) {
      note(reading.file.unused, name);
      return {};
    }
    VoxCursor cursor(content);
    auto read = kind.read(cursor, reading);
    if (cursor.failed())
      return Error::input("a chunk " + std::string(name) + " speaks of more than its " +
                          std::to_string(content.size()) + " bytes hold");
    return read;
  }
  note(reading.file.unknown, name);
  return {};
}

std::string_view takeName(VoxCursor &cursor) {
  const auto bytes = cursor.take(4);
  return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

} // namespace

Expected<VoxFile> readVoxFile(std::span<const std::byte> bytes, std::int32_t frame) {
  VoxCursor cursor(bytes);
  if (takeName(cursor) != "VOX ")
    return Error::input("it does not begin with 'VOX '");
  cursor.word(); // Versions differ in chunks that are left alone.
  if (takeName(cursor) != "MAIN")
    return Error::input("its first chunk is not MAIN");
  const std::uint32_t mainBytes = cursor.word();
  cursor.word(); // Chunks follow up to the end of the file.
  cursor.take(mainBytes);
  Reading reading;
  reading.frame = frame;
  reading.file.colours = defaultVoxPalette();
  reading.file.roughness.fill(1);
  while (!cursor.failed() && cursor.size() > 0) {
    const std::string_view name = takeName(cursor);
    const std::uint32_t content = cursor.word();
    const std::uint32_t children = cursor.word();
    const auto chunk = cursor.take(content);
    cursor.take(children);
    if (!cursor.failed())
      VOXC_TRY(readChunk(name, chunk, reading));
  }
  if (cursor.failed())
    return Error::input("a chunk reaches over its end");
  if (reading.file.models.empty())
    return Error::input("it has no model");
  return std::move(reading.file);
}

} // namespace voxc
