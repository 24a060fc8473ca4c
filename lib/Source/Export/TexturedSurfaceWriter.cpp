// Binary glTF with a texture: rectangles of any colours, a texel for each face of a voxel, and no gap between
// triangles.
#include "Source/Export/FaceAtlas.h"
#include "Source/Export/FaceOutline.h"
#include "Source/Export/GlbFile.h"
#include "Source/Export/LookPaint.h"
#include "Source/Export/LookTexels.h"
#include "Source/Export/LookedVoxels.h"
#include "Source/Export/Writers.h"
#include "voxc/Image/Encode.h"
#include "voxc/Volume/LabelColour.h"

#include <string>
#include <vector>

namespace voxc {

namespace {

struct TexturedVertex {
  std::array<float, 3> position;
  std::array<float, 2> uv;
};
static_assert(sizeof(TexturedVertex) == 20);

/// So far inside of its texels ends a rectangle, in texels, that no rounding leads to those of others.
constexpr float kInset = 1.0f / 32;

class TexturedSurface {
public:
  TexturedSurface(OutputFile &file, const LookedVoxels &voxels, const LookTexels &looks, bool areLabels)
      : file_(file), voxels_(voxels), looks_(looks), areLabels_(areLabels) {}

  /// False if no texture holds more, which `write` will say.
  bool add(const FaceRectangle &face, std::span<const std::uint32_t> words) {
    texels_.clear();
    for (const std::uint32_t word : words) {
      const LookedVoxels::Pair pair = voxels_.pair(word);
      // A voxel is never so clear that it is none.
      const std::uint32_t shown = areLabels_             ? labelColour(pair.word)
                                  : pair.word >> 24 == 0 ? pair.word | 1u << 24
                                                         : pair.word;
      isTranslucent_ = isTranslucent_ || shown >> 24 != 255;
      isBrighter_ = isBrighter_ || isBrighter(looks_.light(pair.look), shown);
      texels_.push_back(wordBelow(shown, looks_.light(pair.look)));
      if (looks_.areAny())
        lookOf_.push_back(pair.look);
    }
    atlas_.add(face.width, face.height, texels_);
    addCorners(face, corners_);
    faces_.push_back(face);
    return !atlas_.isOverfull();
  }

  Expected<void> write(const Transform &voxelToModel) {
    VOXC_TRY(file_.begin(looks_.areAny() ? 2 : 1));
    if (faces_.empty())
      return file_.finish("", voxelToModel);
    VOXC_TRY(atlas_.pack());
    for (auto part :
         {&TexturedSurface::writeVertices, &TexturedSurface::writeIndices, &TexturedSurface::writePictures})
      VOXC_TRY((this->*part)());
    return file_.finish(meshText(), voxelToModel);
  }

  std::uint64_t rectangles() const { return faces_.size(); }
  /// Whether some voxel gives off more light than its colour has.
  bool hasBrighter() const { return isBrighter_; }

private:
  /// What indices are made from.
  struct Fan {
    std::uint16_t points;
    bool hasCentre;
  };

  TexturedVertex vertexOf(std::size_t face, OutlinePoint point) const {
    const FaceRectangle &rectangle = faces_[face];
    const AtlasPlace place = atlas_.place(face);
    const auto along = [](int first, int at, int size, int all) {
      const float share = static_cast<float>(at) / static_cast<float>(size);
      return (static_cast<float>(first) + kInset + share * (static_cast<float>(size) - 2 * kInset)) /
             static_cast<float>(all);
    };
    return {positionOf(cornerOf(rectangle, point)),
            {along(place.x, point.u, rectangle.width, atlas_.width()),
             along(place.y, point.v, rectangle.height, atlas_.height())}};
  }

  /// That of the middle of a rectangle, which need not be a corner of a voxel.
  TexturedVertex centreOf(std::size_t face) const {
    TexturedVertex low = vertexOf(face, {});
    const TexturedVertex high = vertexOf(face, {static_cast<std::uint8_t>(faces_[face].width),
                                                static_cast<std::uint8_t>(faces_[face].height)});
    for (std::size_t i = 0; i < 3; ++i)
      low.position[i] = (low.position[i] + high.position[i]) / 2;
    for (std::size_t i = 0; i < 2; ++i)
      low.uv[i] = (low.uv[i] + high.uv[i]) / 2;
    return low;
  }

  Expected<void> writeVertices() {
    Outline outline;
    std::vector<TexturedVertex> vertices;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      outlineOf(faces_[face], corners_, outline);
      vertices.clear();
      for (const OutlinePoint point : outline.points)
        vertices.push_back(vertexOf(face, point));
      if (outline.hasCentre)
        vertices.back() = centreOf(face);
      for (const TexturedVertex &vertex : vertices)
        bounds_.add(vertex.position);
      fans_.push_back({static_cast<std::uint16_t>(vertices.size()), outline.hasCentre});
      vertices_ += vertices.size();
      triangles_ += outline.triangles();
      VOXC_TRY(file_.write(vertices.data(), vertices.size() * sizeof vertices[0]));
    }
    return {};
  }

  Expected<void> writeIndices() {
    indicesAt_ = file_.bytes();
    std::vector<std::uint32_t> indices;
    std::uint32_t first = 0;
    for (const Fan &fan : fans_) {
      indices.clear();
      const std::uint32_t ring = fan.points - (fan.hasCentre ? 1u : 0u);
      const std::uint32_t apex = fan.hasCentre ? first + ring : first;
      for (std::uint32_t i = fan.hasCentre ? 0 : 1; i < ring - (fan.hasCentre ? 0 : 1); ++i)
        indices.insert(indices.end(), {apex, first + i, first + (i + 1) % ring});
      first += fan.points;
      VOXC_TRY(file_.write(indices.data(), indices.size() * sizeof indices[0]));
    }
    return {};
  }

  /// Colours, then light, then metal, as far as there are some.
  Expected<void> writePictures() {
    VOXC_TRY(writePicture());
    for (const LookTexels::Kind kind : looks_.kinds()) {
      std::vector<std::uint32_t> texels;
      texels.reserve(lookOf_.size());
      for (const std::uint32_t look : lookOf_)
        texels.push_back(looks_.texel(kind, look));
      atlas_.setTexels(std::move(texels));
      VOXC_TRY(writePicture());
    }
    return {};
  }

  Expected<void> writePicture() {
    picturesAt_.push_back(file_.bytes());
    const Expected<std::string> picture = encodePng(atlas_.takePicture(), atlas_.width(), atlas_.height());
    return picture ? file_.write(picture->data(), picture->size()) : Expected<void>(picture.error());
  }

  std::string meshText() const {
    const auto view = [](std::uint64_t from, std::uint64_t to, const char *more) {
      return R"({"buffer":0,"byteOffset":)" + std::to_string(from) + R"(,"byteLength":)" +
             std::to_string(to - from) + more + "}";
    };
    const std::string vertices = std::to_string(vertices_);
    std::string textures, images, views;
    for (std::size_t i = 0; i < picturesAt_.size(); ++i) {
      const std::string comma = i == 0 ? "" : ",";
      const std::uint64_t end = i + 1 < picturesAt_.size() ? picturesAt_[i + 1] : file_.bytes();
      textures += comma + R"({"sampler":0,"source":)" + std::to_string(i) + "}";
      images += comma + R"({"bufferView":)" + std::to_string(i + 2) + R"(,"mimeType":"image/png"})";
      views += "," + view(picturesAt_[i], end, "");
    }
    const std::string material = materialOf(looks_.textures(), isTranslucent_);
    return R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)"
           R"("materials":[)" +
           material + "]" + extensionsOf(material) + R"(,"textures":[)" + textures +
           R"(],"samplers":[{"magFilter":9728,"minFilter":9728,"wrapS":33071,"wrapT":33071}],)"
           R"("images":[)" +
           images + R"(],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
           vertices + "," + bounds_.text() +
           R"(},{"bufferView":0,"byteOffset":12,"componentType":5126,"type":"VEC2","count":)" + vertices +
           R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
           std::to_string(3 * triangles_) + R"(}],"bufferViews":[)" +
           view(0, indicesAt_, R"(,"byteStride":20,"target":34962)") + "," +
           view(indicesAt_, picturesAt_.front(), R"(,"target":34963)") + views + "]";
  }

  GlbFile file_;
  const LookedVoxels &voxels_;
  const LookTexels &looks_;
  bool areLabels_;
  bool isTranslucent_ = false; ///< Some voxel is.
  bool isBrighter_ = false;
  std::vector<std::uint32_t> lookOf_; ///< Of each texel, where something is said of some.
  std::vector<FaceRectangle> faces_;
  std::vector<std::uint32_t> texels_; ///< Of the rectangle in work.
  FaceAtlas atlas_;
  CornerSet corners_;
  std::vector<Fan> fans_; ///< A rectangle each.
  PositionBounds bounds_;
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_ = 0;
  std::uint64_t indicesAt_ = 0; ///< In the buffer.
  std::vector<std::uint64_t> picturesAt_;
};

} // namespace

Expected<void> writeTexturedSurface(const Volume &volume, OutputFile &file, const ExportOptions &options,
                                    Exported &exported) {
  const auto kinds = VOXC_TRY(VoxelLooks::of(volume, options.save.progress));
  LookedVoxels voxels(volume, kinds);
  const LookTexels looks(kinds.all());
  // Labels are seen in colours of their own; what else they are has no place in a mesh.
  TexturedSurface surface(file, voxels, looks, volume.layout().hasLabels());
  const auto add = [&](const FaceRectangle &face, std::span<const std::uint32_t> words) {
    return surface.add(face, words);
  };
  VOXC_TRY(forEachFaceOfAnyColour(volume, add, options.save.progress, voxels.source()));
  exported.rectangles = surface.rectangles();
  if (surface.hasBrighter())
    exported.warnings.emplace_back(kBrighterLight);
  if (std::string warning = looks.warning(); !warning.empty())
    exported.warnings.push_back(std::move(warning));
  return surface.write(volume.info().voxelToModel);
}

} // namespace voxc
