// The chunks of MagicaVoxel files, each with a reader of its own in a table.
#include "Input/MagicaVoxel/VoxFile.h"

#include "Input/MagicaVoxel/VoxCursor.h"
#include "Input/MagicaVoxel/VoxMaterial.h"
#include "Input/MagicaVoxel/VoxPalette.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace voxc {

namespace {

/// Notes a name, unless there are many already: a file could have any number of them.
void note(std::set<std::string> &names, std::string_view name) {
  constexpr std::size_t kMostNamed = 8, kLongest = 32;
  if (names.size() < kMostNamed)
    names.emplace(name.substr(0, kLongest));
}

/// A dictionary of which only "_hidden" matters; of the rest what says something is noted.
bool readHidden(VoxCursor &cursor, VoxFile &file) {
  bool isHidden = false;
  readDictionary(cursor, [&](std::string_view key, std::string_view value) {
    if (key == "_hidden")
      isHidden = isHidden || value == "1";
    else if (!value.empty())
      note(file.unused, key);
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
struct VoxFrame {
  std::int32_t time = 0;
  unsigned rotation = 4; ///< No rotation.
  Long3 translation{};
};

VoxFrame readFrame(VoxCursor &cursor) {
  VoxFrame frame;
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
  std::int32_t frame = 0; ///< That is asked for.
  Long3 size{-1, -1, -1}; ///< Of the next model.
};

/// Chooses among keys: the last in time up to the frame, else the first.
class KeyChoice {
public:
  explicit KeyChoice(Reading &reading) : reading_(reading) {}

  /// Whether a key of this time is the best so far.
  bool takes(std::int32_t time) {
    constexpr std::int32_t kMostFrames = 1 << 20;
    last_ = std::max(last_, std::clamp(time, 0, kMostFrames - 1));
    ++keys_;
    if (keys_ > 1) // A node of one key stays where it is.
      reading_.file.frames = std::max(reading_.file.frames, last_ + 1);
    const bool hasDue = best_ <= reading_.frame;
    const bool isBetter =
        keys_ == 1 || (time <= reading_.frame ? !hasDue || time > best_ : !hasDue && time < best_);
    if (isBetter)
      best_ = time;
    return isBetter;
  }

private:
  Reading &reading_;
  std::uint32_t keys_ = 0;
  std::int32_t best_ = 0; ///< The time of the chosen one.
  std::int32_t last_ = 0;
};

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
  node.isHidden = readHidden(cursor, reading.file);
  node.children = {cursor.word()};
  cursor.word();
  node.layer = static_cast<std::int32_t>(cursor.word());
  VoxFrame chosen;
  KeyChoice choice(reading);
  for (std::uint32_t frames = cursor.count(4); frames > 0 && !cursor.failed(); --frames)
    if (const VoxFrame frame = readFrame(cursor); choice.takes(frame.time))
      chosen = frame;
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
  node.isHidden = readHidden(cursor, reading.file);
  node.children.resize(cursor.count(4));
  for (std::uint32_t &child : node.children)
    child = cursor.word();
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readShape(VoxCursor &cursor, Reading &reading) {
  VoxNode node;
  node.kind = VoxNode::Kind::Shape;
  const std::uint32_t number = cursor.word();
  node.isHidden = readHidden(cursor, reading.file);
  const std::uint32_t models = cursor.count(8);
  if (models == 0 && !cursor.failed())
    return Error::input("the shape " + std::to_string(number) + " has no model");
  KeyChoice choice(reading);
  for (std::uint32_t i = 0; i < models && !cursor.failed(); ++i) {
    const std::uint32_t model = cursor.word();
    if (const VoxFrame frame = readFrame(cursor); choice.takes(frame.time))
      node.model = model;
  }
  return addNode(reading.file, number, std::move(node));
}

Expected<void> readLayer(VoxCursor &cursor, Reading &reading) {
  const auto number = static_cast<std::int32_t>(cursor.word());
  if (readHidden(cursor, reading.file))
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
