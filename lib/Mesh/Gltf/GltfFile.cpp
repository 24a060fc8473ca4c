// Finding the chunks of .glb files.
#include "Mesh/Gltf/GltfFile.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace voxc {

namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kJson = 0x4e4f534a;   // "JSON"
constexpr std::uint32_t kBinary = 0x004e4942; // "BIN\0"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t offset) {
  std::array<std::uint8_t, 4> four;
  std::memcpy(four.data(), bytes.data() + offset, four.size());
  return four[0] | four[1] << 8u | four[2] << 16u | std::uint32_t{four[3]} << 24u;
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};

/// Takes the next chunk off the front of `rest`; nothing if it is not all there.
std::optional<Chunk> takeChunk(std::span<const std::byte> &rest) {
  if (rest.size() < kChunkHeaderBytes)
    return std::nullopt;
  const std::uint32_t length = wordAt(rest, 0);
  if (rest.size() - kChunkHeaderBytes < length)
    return std::nullopt;
  const Chunk chunk{wordAt(rest, 4), rest.subspan(kChunkHeaderBytes, length)};
  rest = rest.subspan(kChunkHeaderBytes + length);
  return chunk;
}

/// Whether the first character that is not white is that of an object. A byte order mark may precede it.
bool mayBeJson(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  if (text.starts_with("\xef\xbb\xbf"))
    text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

} // namespace

Expected<GltfFile> splitGltf(std::span<const std::byte> bytes) {
  if (bytes.size() < 4 || wordAt(bytes, 0) != kMagic) {
    if (!mayBeJson(bytes))
      return Error::input("it begins neither with 'glTF', as a .glb file does, nor with a JSON object");
    return GltfFile{bytes, std::nullopt, 0};
  }
  if (bytes.size() < kHeaderBytes)
    return Error::input("its header is cut short");
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return Error::input("it is a .glb of version " + std::to_string(version) + "; only version 2 is read");
  const std::uint32_t length = wordAt(bytes, 8);
  if (length < kHeaderBytes || length > bytes.size())
    return Error::input("it claims to have " + std::to_string(length) + " bytes, but has " +
                        std::to_string(bytes.size()));
  std::span<const std::byte> rest = bytes.subspan(kHeaderBytes, length - kHeaderBytes);
  const auto json = takeChunk(rest);
  if (!json || json->type != kJson)
    return Error::input("its first chunk is not JSON, or is cut short");
  const std::uint64_t behind = bytes.size() - length;
  GltfFile file{json->bytes, std::nullopt, behind + rest.size()};
  // Chunks of other types may follow; a binary one is the second.
  if (rest.size() < kChunkHeaderBytes)
    return file;
  const auto binary = takeChunk(rest);
  if (!binary)
    return Error::input("its second chunk is cut short");
  if (binary->type == kBinary) {
    file.binary = binary->bytes;
    file.others = behind + rest.size();
  }
  return file;
}

} // namespace voxc
