// Binary glTF with a colour a vertex: the corners of rectangles as they are found, then their indices.
#include "Source/Export/Faces.h"
#include "Source/Export/GlbFile.h"
#include "Source/Export/LookPaint.h"
#include "Source/Export/LookedVoxels.h"
#include "Source/Export/Writers.h"
#include "voxc/Volume/LabelColour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace voxc {

namespace {

struct Vertex {
  std::array<float, 3> position;       ///< In voxels, which float32 holds exactly.
  std::array<std::uint16_t, 4> colour; ///< Linear light, as glTF has it, and alpha, of 65535.
};
static_assert(sizeof(Vertex) == 20);

/// 16 bits tell the light of all bytes in sRGB apart. `light` is that which the material adds.
std::array<std::uint16_t, 4> linearColour(std::uint32_t word, const std::array<double, 3> &light) {
  const std::array<double, 3> below = lightBelow(word, light);
  std::array<std::uint16_t, 4> colour;
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint16_t>(std::lround(below[i] * 65535));
  // A voxel is never so clear that it is none.
  colour[3] = static_cast<std::uint16_t>(std::max(word >> 24, std::uint32_t{1}) * 257);
  return colour;
}

constexpr std::uint64_t kCorners = 4;
constexpr std::uint64_t kIndices = 6;
/// The corners counter-clockwise as seen from outside.
std::array<Vertex, kCorners> cornersOf(const FaceRectangle &face, const std::array<double, 3> &light) {
  constexpr std::array<std::array<int, 2>, kCorners> kTurn{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<Vertex, kCorners> corners;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const auto [u, v] = kTurn[face.isHigh ? i : kCorners - 1 - i];
    Int3 corner = face.low;
    corner[face.axis] += face.isHigh;
    corner[(face.axis + 1) % 3] += u * face.width;
    corner[(face.axis + 2) % 3] += v * face.height;
    corners[i].position = positionOf(corner);
    corners[i].colour = linearColour(face.word, light);
  }
  return corners;
}

/// So many materials may a file have: each is some text in its head.
constexpr std::size_t kMostMaterials = 4096;

/// Rectangles one behind the other, then their indices, those of one look together: a primitive each.
class SurfaceFile {
public:
  SurfaceFile(OutputFile &file, std::span<const VoxelLook> looks) : file_(file), looks_(looks) {
    for (const VoxelLook &look : looks)
      lights_.push_back(givenLight(look));
    rectanglesOf_.resize(looks.size());
  }

  Expected<void> begin() { return file_.begin(looks_.size()); }

  Expected<void> add(const FaceRectangle &face, std::uint32_t look) {
    ++rectangles_;
    ++rectanglesOf_[look];
    if (looks_.size() > 1)
      lookOf_.push_back(look);
    isTranslucent_ = isTranslucent_ || face.word >> 24 != 255;
    isBrighter_ = isBrighter_ || isBrighter(lights_[look], face.word);
    const auto corners = cornersOf(face, lights_[look]);
    for (const Vertex &corner : corners)
      bounds_.add(corner.position);
    return file_.write(corners.data(), sizeof corners);
  }

  Expected<void> finish(const Transform &voxelToModel) {
    VOXC_TRY(writeIndices());
    return file_.finish(rectangles_ == 0 ? "" : meshText(), voxelToModel);
  }

  std::uint64_t rectangles() const { return rectangles_; }
  /// Whether some voxel gives off more light than its colour has.
  bool hasBrighter() const { return isBrighter_; }

private:
  Expected<void> writeIndices() {
    if (looks_.size() > 1)
      return writeIndicesByLook();
    std::vector<std::uint32_t> indices;
    constexpr std::uint64_t kAtOnce = 4096;
    for (std::uint64_t i = 0; i < rectangles_;) {
      indices.clear();
      for (const std::uint64_t end = std::min(i + kAtOnce, rectangles_); i < end; ++i)
        addIndices(i, indices);
      VOXC_TRY(file_.write(indices.data(), indices.size() * sizeof indices[0]));
    }
    return {};
  }

  Expected<void> writeIndicesByLook() {
    std::vector<std::uint32_t> order(rectangles_);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return lookOf_[i]; });
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t i : order) {
      indices.clear();
      addIndices(i, indices);
      VOXC_TRY(file_.write(indices.data(), indices.size() * sizeof indices[0]));
    }
    return {};
  }

  static void addIndices(std::uint64_t rectangle, std::vector<std::uint32_t> &indices) {
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
      indices.push_back(static_cast<std::uint32_t>(rectangle * kCorners) + corner);
  }

  /// The primitives, materials and accessors of indices of the looks that faces have.
  struct LookTexts {
    std::string primitives, materials, accessors;
  };

  LookTexts lookTexts() const {
    LookTexts texts;
    std::uint64_t first = 0;
    int material = 0;
    for (std::size_t look = 0; look < looks_.size(); ++look) {
      const std::uint64_t count = rectanglesOf_[look];
      if (count == 0)
        continue;
      const std::string comma = material == 0 ? "" : ",";
      texts.primitives += comma + R"({"attributes":{"POSITION":0,"COLOR_0":1},"indices":)" +
                          std::to_string(material + 2) + R"(,"material":)" + std::to_string(material) + "}";
      texts.materials += comma + materialOf(looks_[look], isTranslucent_);
      texts.accessors +=
          R"(,{"bufferView":1,)" +
          (first == 0 ? std::string() : R"("byteOffset":)" + std::to_string(first * kIndices * 4) + ",") +
          R"("componentType":5125,"type":"SCALAR","count":)" + std::to_string(count * kIndices) + "}";
      first += count;
      ++material;
    }
    return texts;
  }

  std::string meshText() const {
    const std::string vertices = std::to_string(rectangles_ * kCorners);
    const std::string vertexBytes = std::to_string(rectangles_ * kCorners * sizeof(Vertex));
    const std::string indexBytes = std::to_string(rectangles_ * kIndices * sizeof(std::uint32_t));
    const LookTexts texts = lookTexts();
    return R"("meshes":[{"primitives":[)" + texts.primitives + R"(]}],"materials":[)" + texts.materials +
           "]" + extensionsOf(texts.materials) +
           R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + vertices + "," +
           bounds_.text() +
           R"(},{"bufferView":0,"byteOffset":12,"componentType":5123,"normalized":true,"type":"VEC4","count":)" +
           vertices + "}" + texts.accessors + R"(],"bufferViews":[{"buffer":0,"byteLength":)" + vertexBytes +
           R"(,"byteStride":20,"target":34962},{"buffer":0,"byteOffset":)" + vertexBytes +
           R"(,"byteLength":)" + indexBytes + R"(,"target":34963}])";
  }

  GlbFile file_;
  std::span<const VoxelLook> looks_;
  std::vector<std::array<double, 3>> lights_; ///< Of looks.
  std::vector<std::uint64_t> rectanglesOf_;   ///< So many has each look.
  std::vector<std::uint32_t> lookOf_;         ///< The look of each rectangle, where there are several.
  std::uint64_t rectangles_ = 0;
  bool isTranslucent_ = false; ///< Some voxel is.
  bool isBrighter_ = false;
  PositionBounds bounds_;
};

} // namespace

Expected<void> writeSurface(const Volume &volume, OutputFile &file, const ExportOptions &options,
                            Exported &exported) {
  auto looks = VoxelLooks::of(volume, options.save.progress);
  if (!looks)
    return looks.error();
  if (looks->all().size() > kMostMaterials) {
    exported.warnings.push_back("its voxels have " + std::to_string(looks->all().size() - 1) +
                                " kinds of light and metal, more than the 4096 materials of a .glb file, "
                                "which are left out; --texture keeps them");
    looks = VoxelLooks();
  }
  LookedVoxels voxels(volume, *looks);
  SurfaceFile surface(file, looks->all());
  Expected<void> written = surface.begin();
  if (!written)
    return written;
  // Labels are seen in colours of their own; what else they are has no place in a mesh.
  const bool areLabels = volume.layout().hasLabels();
  const auto add = [&](FaceRectangle face) {
    const LookedVoxels::Pair pair = voxels.pair(face.word);
    face.word = areLabels ? labelColour(pair.word) : pair.word;
    written = surface.add(face, pair.look);
    return bool(written);
  };
  VOXC_TRY(forEachFace(volume, add, options.save.progress, voxels.source()));
  if (!written)
    return written;
  exported.rectangles = surface.rectangles();
  if (surface.hasBrighter())
    exported.warnings.emplace_back(kBrighterLight);
  return surface.finish(volume.info().voxelToModel);
}

} // namespace voxc
