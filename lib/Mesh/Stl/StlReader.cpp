// Telling binary from text, and reading each.
#include "Mesh/Stl/StlReader.h"

#include "Mesh/KeptArray.h"
#include "Mesh/Stl/StlColours.h"
#include "Mesh/Stl/StlText.h"
#include "Support/Problem.h"
#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace voxc {

namespace {

using StlCorner = std::array<float, 3>;

constexpr std::size_t kHeaderBytes = 84; ///< 80 of any text, and the number of triangles.
constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50; ///< A normal, three corners, two bytes that may be a colour.
constexpr std::size_t kColourOffset = 48;
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kCornerBytes = 12;
constexpr std::uint64_t kBlock = 4096;

std::uint32_t littleWord(const std::byte *at) {
  std::array<std::uint8_t, 4> bytes;
  std::memcpy(bytes.data(), at, bytes.size());
  return bytes[0] | bytes[1] << 8u | bytes[2] << 16u | std::uint32_t{bytes[3]} << 24u;
}

std::uint32_t bigWord(const std::byte *at) {
  const std::uint32_t word = littleWord(at);
  return word >> 24 | (word >> 8 & 0xff00) | (word << 8 & 0xff0000) | word << 24;
}

StlCorner cornerAt(const std::byte *at) {
  return {std::bit_cast<float>(littleWord(at)), std::bit_cast<float>(littleWord(at + 4)),
          std::bit_cast<float>(littleWord(at + 8))};
}

bool isOfSize(std::span<const std::byte> bytes, std::uint64_t triangles) {
  return kHeaderBytes + triangles * kTriangleBytes == bytes.size();
}

bool isOfBinarySize(std::span<const std::byte> bytes) {
  return bytes.size() >= kHeaderBytes && isOfSize(bytes, littleWord(bytes.data() + kCountOffset));
}

/// What is wrong with a file that is neither binary nor text as STL has them, but nearly; empty if nothing
/// is.
std::string nearlyStl(std::span<const std::byte> bytes) {
  if (isOfBinarySize(bytes))
    return {};
  if (bytes.size() >= kHeaderBytes && isOfSize(bytes, bigWord(bytes.data() + kCountOffset)))
    return "its numbers are big-endian, and those of STL are little-endian; save it anew as STL, or as .ply";
  const std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const bool isComment = begin != std::string_view::npos && (text[begin] == ';' || text[begin] == '#');
  if (isComment && text.substr(0, 512).find('\0') == std::string_view::npos)
    return "it begins with a comment, which STL does not have; take out the lines that begin with '" +
           std::string(1, text[begin]) + "'";
  return {};
}

/// Many binary files begin with "solid" as the text does, so what follows decides.
bool isText(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  if (text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || lowerCase(text.substr(begin, 5)) != "solid")
    return false;
  if (isOfBinarySize(bytes))
    return false;
  return text.substr(0, 512).find('\0') == std::string_view::npos;
}

std::uint16_t coloursAt(const std::byte *triangle) {
  std::array<std::uint8_t, 2> bytes;
  std::memcpy(bytes.data(), triangle + kColourOffset, bytes.size());
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

/// The colour of each corner, if triangles have colours.
void readColours(const MeshInput &input, const StlColours &colours, ScratchArray<std::uint32_t> &words,
                 std::uint64_t count, Problem &problem) {
  for (std::uint64_t i = 0; i < count && !problem; ++i) {
    if (i % kBlock == 0 && !input.at(i, count))
      return problem.set(Error::interrupted());
    const std::uint32_t word =
        colours(coloursAt(input.file->bytes().data() + kHeaderBytes + i * kTriangleBytes));
    problem.check(words.append(std::array{word, word, word}));
  }
}

/// How many triangles there are: as many as the header says, unless it says none or -1, as programs do that
/// write it before they know.
std::uint64_t countOf(std::span<const std::byte> bytes, std::vector<std::string> &warnings) {
  const std::uint64_t claimed = littleWord(bytes.data() + kCountOffset);
  const std::uint64_t room = bytes.size() - kHeaderBytes, there = room / kTriangleBytes;
  const bool isUnknown = claimed == 0 || claimed == 0xffffffff;
  if (isUnknown && there > 0 && room % kTriangleBytes == 0) {
    warnings.push_back("its header does not say how many triangles it has; all are taken, " +
                       std::to_string(there));
    return there;
  }
  if (claimed < there || (claimed == there && room % kTriangleBytes != 0))
    warnings.push_back(countedAre(room - claimed * kTriangleBytes, "byte") +
                       " left out, which lie behind the " + counted(claimed, "triangle") +
                       " that its header says");
  return claimed;
}

void readBinary(const MeshInput &input, ScratchArray<StlCorner> &corners, StlColours &colours,
                std::vector<std::string> &warnings, Problem &problem) {
  const std::span<const std::byte> bytes = input.file->bytes();
  const std::string_view encoding = wideEncoding(input.file->text());
  if (!encoding.empty() && !isOfBinarySize(bytes))
    return problem.set(isWideText(encoding));
  if (std::string what = nearlyStl(bytes); !what.empty())
    return problem.set(std::move(what));
  if (bytes.size() < kHeaderBytes)
    return problem.set("it is neither the text 'solid' nor has it the 84 bytes of a binary header");
  const std::uint64_t count = countOf(bytes, warnings);
  if (count > (bytes.size() - kHeaderBytes) / kTriangleBytes)
    return problem.set("it claims " + std::to_string(count) + " triangles, but has only " +
                       std::to_string(bytes.size() - kHeaderBytes) + " bytes for them");
  if (auto resized = corners.resize(3 * count); !resized)
    return problem.check(resized);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % kBlock == 0 && !input.at(i, count))
      return problem.set(Error::interrupted());
    const std::byte *triangle = bytes.data() + kHeaderBytes + i * kTriangleBytes;
    for (std::size_t corner = 0; corner < 3; ++corner)
      corners[3 * i + corner] = cornerAt(triangle + kNormalBytes + corner * kCornerBytes);
    colours.look(coloursAt(triangle));
  }
}

} // namespace

Expected<TriangleScene> readStl(const MeshInput &input) {
  Problem problem;
  TriangleScene scene;
  MeshPart part;
  if (isText(input.file->bytes())) {
    ScratchArray<StlTextCorner> corners(input.memory);
    readStlText(input, corners, problem);
    part.positions = keep(std::move(corners), kDoubleRows3, scene);
  } else {
    ScratchArray<StlCorner> corners(input.memory);
    StlColours colours(input.file->bytes().first(std::min(kCountOffset, input.file->bytes().size())));
    readBinary(input, corners, colours, scene.warnings, problem);
    ScratchArray<std::uint32_t> words(input.memory);
    if (!problem && colours.areThere())
      readColours(input, colours, words, corners.size() / 3, problem);
    if (std::string warning = colours.warning(); !warning.empty())
      scene.warnings.push_back(std::move(warning));
    part.positions = keep(std::move(corners), kFloatRows3, scene);
    part.colours = keep(std::move(words), kColourRows, scene);
  }
  if (problem)
    return problem.error();
  scene.materials.emplace_back();
  scene.parts.push_back(part);
  scene.instances.push_back({});
  return scene;
}

} // namespace voxc
