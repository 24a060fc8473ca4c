// The head of a .glb file, which says how long all is that follows.
#include "Source/Export/GlbFile.h"

#include <algorithm>
#include <cstdio>

namespace voxc {

namespace {

constexpr std::uint32_t kOneMaterial = 2044; ///< Of the head's text,
constexpr std::uint32_t kEachMore = 768;     ///< and for each material more.

std::string numberText(double number) {
  std::array<char, 32> text;
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.17g", number))};
}

std::string boundText(const std::array<float, 3> &bound) {
  return "[" + numberText(bound[0]) + "," + numberText(bound[1]) + "," + numberText(bound[2]) + "]";
}

/// Column by column, with the row that every affine map has.
std::string matrixText(const Transform &transform) {
  std::string text;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row)
      text += numberText(transform[column][row]) + ",";
    text += column < 3 ? "0," : "1";
  }
  return text;
}

/// Padded with blanks to a size, so that it can be written last.
std::string jsonOf(const std::string &mesh, std::uint64_t bytes, const Transform &voxelToModel,
                   std::uint32_t size) {
  std::string node = mesh.empty() ? "" : R"("mesh":0)";
  if (isFinite(voxelToModel) && rowsOf(voxelToModel) != rowsOf(Transform()))
    node += std::string(mesh.empty() ? "" : ",") + R"("matrix":[)" + matrixText(voxelToModel) + "]";
  std::string json = R"({"asset":{"version":"2.0","generator":"voxc"},"scene":0,"scenes":[{"nodes":[0]}],)"
                     R"("nodes":[{)" +
                     node + "}]";
  if (!mesh.empty())
    json += "," + mesh + R"(,"buffers":[{"byteLength":)" + std::to_string(bytes) + "}]";
  json += "}";
  json.resize(size, ' ');
  return json;
}

} // namespace

void PositionBounds::add(const std::array<float, 3> &position) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::min(low_[axis], position[axis]);
    high_[axis] = std::max(high_[axis], position[axis]);
  }
}

std::string PositionBounds::text() const {
  return R"("min":)" + boundText(low_) + R"(,"max":)" + boundText(high_);
}

std::string jsonNumber(double number) {
  std::array<char, 32> text;
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.9g", number))};
}

Expected<void> GlbFile::begin(std::size_t materials) {
  jsonBytes_ = kOneMaterial + kEachMore * static_cast<std::uint32_t>(std::max<std::size_t>(materials, 1) - 1);
  const std::string room(binaryOffset(), ' ');
  return file_.write(room.data(), room.size());
}

Expected<void> GlbFile::write(const void *bytes, std::uint64_t size) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (size > kMost - binaryOffset() - 3 - bytes_)
    return Error::input(
        "the surface takes more than the 4 GiB that a .glb file can hold; export a part of it, or points");
  bytes_ += size;
  return file_.write(bytes, size);
}

Expected<void> GlbFile::finish(const std::string &mesh, const Transform &voxelToModel) {
  constexpr std::array<char, 3> kPadding{};
  VOXC_TRY(write(kPadding.data(), -bytes_ % 4));
  std::string head = "glTF";
  const auto word = [&](std::uint64_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    head.append(reinterpret_cast<const char *>(&narrow), sizeof narrow);
  };
  word(2);
  word(binaryOffset() + bytes_);
  word(jsonBytes_);
  head += "JSON" + jsonOf(mesh, bytes_, voxelToModel, jsonBytes_);
  word(bytes_);
  head += std::string("BIN\0", 4);
  return file_.rewrite(0, head.data(), head.size());
}

} // namespace voxc
