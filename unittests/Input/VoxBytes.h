// Making MagicaVoxel files for tests.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

namespace voxc {

/// Little-endian words and texts, put together as MagicaVoxel does.
inline std::string wordBytes(std::initializer_list<std::uint32_t> words) {
  std::string bytes;
  for (const std::uint32_t word : words)
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<char>(word >> shift & 255));
  return bytes;
}

inline std::string textBytes(const std::string &text) {
  return wordBytes({static_cast<std::uint32_t>(text.size())}) + text;
}

inline std::string chunkBytes(const std::string &name, const std::string &content) {
  return name + wordBytes({static_cast<std::uint32_t>(content.size()), 0}) + content;
}

using Pairs = std::initializer_list<std::pair<const char *, std::string>>;

inline std::string dictionaryBytes(Pairs pairs) {
  std::string bytes = wordBytes({static_cast<std::uint32_t>(pairs.size())});
  for (const auto &[key, value] : pairs)
    bytes += textBytes(key) + textBytes(value);
  return bytes;
}

inline std::string voxBytes(const std::string &chunks) {
  return "VOX " + wordBytes({150}) + "MAIN" + wordBytes({0, static_cast<std::uint32_t>(chunks.size())}) +
         chunks;
}

struct VoxCell {
  int x, y, z, colour;
};

inline std::string modelChunks(std::uint32_t x, std::uint32_t y, std::uint32_t z,
                               std::initializer_list<VoxCell> cells) {
  std::string voxels = wordBytes({static_cast<std::uint32_t>(cells.size())});
  for (const VoxCell &cell : cells)
    for (const int byte : {cell.x, cell.y, cell.z, cell.colour})
      voxels.push_back(static_cast<char>(byte));
  return chunkBytes("SIZE", wordBytes({x, y, z})) + chunkBytes("XYZI", voxels);
}

/// A transform with one frame.
inline std::string transformChunk(std::uint32_t number, std::uint32_t child, Pairs frame, Pairs node = {},
                                  std::uint32_t layer = 0xffffffff) {
  return chunkBytes("nTRN", wordBytes({number}) + dictionaryBytes(node) +
                                wordBytes({child, 0xffffffff, layer, 1}) + dictionaryBytes(frame));
}

inline std::string groupChunk(std::uint32_t number, std::initializer_list<std::uint32_t> children,
                              Pairs node = {}) {
  return chunkBytes("nGRP", wordBytes({number}) + dictionaryBytes(node) +
                                wordBytes({static_cast<std::uint32_t>(children.size())}) +
                                wordBytes(children));
}

inline std::string shapeChunk(std::uint32_t number, std::uint32_t model, Pairs node = {}) {
  return chunkBytes("nSHP", wordBytes({number}) + dictionaryBytes(node) + wordBytes({1, model}) +
                                dictionaryBytes({}));
}

} // namespace voxc
