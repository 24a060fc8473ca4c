// Binary glTF with a colour a vertex: the corners of rectangles as they are found, then their indices.
#include "Source/Export/Faces.h"
#include "Source/Export/GlbFile.h"
#include "Source/Export/Writers.h"
#include "Support/Srgb.h"
#include "voxc/Volume/LabelColour.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace voxc {

namespace {

struct Vertex {
  std::array<float, 3> position;       ///< In voxels, which float32 holds exactly.
  std::array<std::uint16_t, 4> colour; ///< Linear light, as glTF has it, and alpha, of 65535.
};
static_assert(sizeof(Vertex) == 20);

/// 16 bits tell the light of all bytes in sRGB apart.
std::array<std::uint16_t, 4> linearColour(std::uint32_t word) {
  std::array<std::uint16_t, 4> colour;
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint16_t>(kLinearLight[word >> 8 * i & 255] * 65535 + 0.5);
  // A voxel is never so clear that it is none.
  colour[3] = static_cast<std::uint16_t>(std::max(word >> 24, std::uint32_t{1}) * 257);
  return colour;
}

constexpr std::uint64_t kCorners = 4;
constexpr std::uint64_t kIndices = 6;
/// The corners counter-clockwise as seen from outside.
std::array<Vertex, kCorners> cornersOf(const FaceRectangle &face) {
  constexpr std::array<std::array<int, 2>, kCorners> kTurn{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<Vertex, kCorners> corners;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const auto [u, v] = kTurn[face.isHigh ? i : kCorners - 1 - i];
    Int3 corner = face.low;
    corner[face.axis] += face.isHigh;
    corner[(face.axis + 1) % 3] += u * face.width;
    corner[(face.axis + 2) % 3] += v * face.height;
    corners[i].position = positionOf(corner);
    corners[i].colour = linearColour(face.word);
  }
  return corners;
}

class SurfaceFile {
public:
  explicit SurfaceFile(OutputFile &file) : file_(file) {}

  Expected<void> begin() { return file_.begin(); }

  Expected<void> add(const FaceRectangle &face) {
    ++rectangles_;
    isTranslucent_ = isTranslucent_ || face.word >> 24 != 255;
    const auto corners = cornersOf(face);
    for (const Vertex &corner : corners)
      bounds_.add(corner.position);
    return file_.write(corners.data(), sizeof corners);
  }

  Expected<void> finish(const Transform &voxelToModel) {
    if (auto written = writeIndices(); !written)
      return written;
    return file_.finish(rectangles_ == 0 ? "" : meshText(), voxelToModel);
  }

  std::uint64_t rectangles() const { return rectangles_; }

private:
  Expected<void> writeIndices() {
    std::vector<std::uint32_t> indices;
    constexpr std::uint64_t kAtOnce = 4096;
    for (std::uint64_t i = 0; i < rectangles_;) {
      indices.clear();
      for (const std::uint64_t end = std::min(i + kAtOnce, rectangles_); i < end; ++i)
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
          indices.push_back(static_cast<std::uint32_t>(i * kCorners) + corner);
      if (auto written = file_.write(indices.data(), indices.size() * sizeof indices[0]); !written)
        return written;
    }
    return {};
  }

  std::string meshText() const {
    const std::string vertices = std::to_string(rectangles_ * kCorners);
    const std::string vertexBytes = std::to_string(rectangles_ * kCorners * sizeof(Vertex));
    const std::string indices = std::to_string(rectangles_ * kIndices);
    const std::string indexBytes = std::to_string(rectangles_ * kIndices * sizeof(std::uint32_t));
    return R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2,"material":0}]}],)"
           R"("materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":1})" +
           std::string(isTranslucent_ ? R"(,"alphaMode":"BLEND")" : "") +
           R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + vertices + "," +
           bounds_.text() +
           R"(},{"bufferView":0,"byteOffset":12,"componentType":5123,"normalized":true,"type":"VEC4","count":)" +
           vertices + R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" + indices +
           R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + vertexBytes +
           R"(,"byteStride":20,"target":34962},{"buffer":0,"byteOffset":)" + vertexBytes +
           R"(,"byteLength":)" + indexBytes + R"(,"target":34963}])";
  }

  GlbFile file_;
  std::uint64_t rectangles_ = 0;
  bool isTranslucent_ = false; ///< Some voxel is.
  PositionBounds bounds_;
};

} // namespace

Expected<void> writeSurface(const Volume &volume, OutputFile &file, const ExportOptions &options,
                            Exported &exported) {
  SurfaceFile surface(file);
  Expected<void> written = surface.begin();
  if (!written)
    return written;
  // Labels are seen in colours of their own; what else they are has no place in a mesh.
  const bool areLabels = volume.layout().payload == Payload::Material;
  const auto add = [&](FaceRectangle face) {
    face.word = areLabels ? labelColour(face.word) : face.word;
    written = surface.add(face);
    return bool(written);
  };
  if (auto walked = forEachFace(volume, add, options.save.progress); !walked)
    return walked;
  if (!written)
    return written;
  exported.rectangles = surface.rectangles();
  return surface.finish(volume.info().voxelToModel);
}

} // namespace voxc
