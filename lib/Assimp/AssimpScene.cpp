// Meshes once, and an instance for each node that has them.
#include "Assimp/AssimpScene.h"

#include "Assimp/AssimpMaterials.h"
#include "Mesh/ColourScale.h"
#include "Mesh/KeptArray.h"
#include "Mesh/Polygon.h"
#include "Support/PathEnding.h"
#include "Support/Problem.h"

#include <array>
#include <utility>
#include <vector>

namespace voxc {

namespace {

constexpr unsigned kBlock = 4096;
constexpr std::size_t kDeepest = 1024; ///< Nodes below each other.

Transform transformOf(const aiMatrix4x4 &m) {
  return transformOfRows({m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4});
}

/// What turns the up of a scene to +y. Of .fbx files assimp tells which axis it is, and leaves them as they
/// are.
Transform toUpright(const aiScene &scene) {
  std::int32_t axis = 1, sign = 1;
  if (scene.mMetaData) {
    scene.mMetaData->Get("UpAxis", axis);
    scene.mMetaData->Get("UpAxisSign", sign);
  }
  const double up = sign < 0 ? -1 : 1;
  if (axis == 0)
    return transformOfRows({0, -up, 0, 0, up, 0, 0, 0, 0, 0, 1, 0});
  if (axis == 2)
    return transformOfRows({1, 0, 0, 0, 0, 0, up, 0, 0, -up, 0, 0});
  return transformOfRows({1, 0, 0, 0, 0, up, 0, 0, 0, 0, up, 0});
}

/// Which of a mesh's parts are faces, lines and points.
constexpr std::array<PrimitiveMode, 3> kModes{PrimitiveMode::Points, PrimitiveMode::Lines,
                                              PrimitiveMode::Triangles};

class SceneCopier {
public:
  SceneCopier(const aiScene &from, const MeshInput &input, Warnings &warnings)
      : from_(from), input_(input), warnings_(warnings), materials_(from, input, scene_, warnings, problem_) {
  }

  Expected<TriangleScene> copy() {
    materials_.readAll();
    measureColours();
    for (unsigned i = 0; i < from_.mNumMeshes && !problem_; ++i)
      addMesh(*from_.mMeshes[i]);
    if (from_.mRootNode && !problem_)
      addNode(*from_.mRootNode, toUpright(from_), 0);
    warn();
    scene_.loaderPeakBytes += materials_.libraryPeakBytes();
    if (problem_)
      return problem_.error();
    return std::move(scene_);
  }

private:
  /// Parts of a mesh, from the first on.
  struct Parts {
    std::uint32_t first;
    std::uint32_t end;
  };

  /// Before any is copied: what stands for the brightest is the same in all meshes.
  void measureColours() {
    if (pathEnding(input_.path) != ".off")
      return; // Others say fractions; above 1 is light that is too bright.
    for (unsigned i = 0; i < from_.mNumMeshes; ++i) {
      const aiMesh &mesh = *from_.mMeshes[i];
      for (unsigned j = 0; mesh.HasVertexColors(0) && j < mesh.mNumVertices; ++j) {
        const aiColor4D &colour = mesh.mColors[0][j];
        for (const float channel : {colour.r, colour.g, colour.b})
          colourScale_.add(channel);
        alphaScale_.add(colour.a);
      }
    }
  }

  AttributeView coloursOf(const aiMesh &mesh) {
    const auto whole = static_cast<float>(colourScale_.whole());
    const auto wholeAlpha = static_cast<float>(alphaScale_.whole());
    return rows<std::array<float, 4>>(mesh, {AttributeView::Type::Float32, 4}, [&](unsigned i) {
      const aiColor4D &colour = mesh.mColors[0][i];
      return std::array{colour.r / whole, colour.g / whole, colour.b / whole, colour.a / wholeAlpha};
    });
  }

  void addMesh(const aiMesh &mesh) {
    Parts parts{static_cast<std::uint32_t>(scene_.parts.size()), 0};
    MeshPart part;
    part.material =
        std::min<std::uint32_t>(mesh.mMaterialIndex, static_cast<std::uint32_t>(scene_.materials.size() - 1));
    part.positions = rows<std::array<float, 3>>(mesh, kFloatRows3, [&](unsigned i) {
      return std::array{mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z};
    });
    const AssimpUvSets sets = materials_.uvSets(mesh.mMaterialIndex);
    const Material &material = scene_.materials[part.material];
    part.uvs = uvsOf(mesh, sets.colour);
    if (material.emissionTexture.texture >= 0)
      part.emissionUvs = sets.emission == sets.colour ? part.uvs : uvsOf(mesh, sets.emission);
    if (mesh.HasVertexColors(0))
      part.colours = coloursOf(mesh);
    // An .off file has no materials: assimp gives it a grey one, which would darken the colours.
    if (part.colours && pathEnding(input_.path) == ".off")
      scene_.materials[part.material].colour = {1, 1, 1, 1};
    lacksUvs_ = lacksUvs_ || (!part.uvs && material.texture.texture >= 0) ||
                (!part.emissionUvs && material.emissionTexture.texture >= 0);
    addIndices(mesh, part);
    parts.end = static_cast<std::uint32_t>(scene_.parts.size());
    parts_.push_back(parts);
    hasBones_ = hasBones_ || mesh.HasBones();
    hasMorphs_ = hasMorphs_ || mesh.mNumAnimMeshes != 0;
  }

  /// None if the mesh has no such set.
  AttributeView uvsOf(const aiMesh &mesh, unsigned set) {
    if (!mesh.HasTextureCoords(set))
      return {};
    return rows<std::array<float, 2>>(mesh, kFloatRows2, [&](unsigned i) {
      return std::array{mesh.mTextureCoords[set][i].x, mesh.mTextureCoords[set][i].y};
    });
  }

  template <typename Row, typename Of> AttributeView rows(const aiMesh &mesh, RowKind kind, const Of &rowOf) {
    ScratchArray<Row> copied(input_.memory);
    for (unsigned i = 0; i < mesh.mNumVertices && !problem_; ++i) {
      if (i % kBlock == 0 && !input_.at(i, mesh.mNumVertices))
        problem_.set(Error::interrupted());
      problem_.check(copied.push(rowOf(i)));
    }
    return keep(std::move(copied), kind, scene_);
  }

  /// A part for the points, one for the lines and one for the faces, as far as there are such.
  void addIndices(const aiMesh &mesh, MeshPart part) {
    std::array<ScratchArray<std::uint32_t>, 3> indices{ScratchArray<std::uint32_t>(input_.memory),
                                                       ScratchArray<std::uint32_t>(input_.memory),
                                                       ScratchArray<std::uint32_t>(input_.memory)};
    for (unsigned i = 0; i < mesh.mNumFaces && !problem_; ++i) {
      const aiFace &face = mesh.mFaces[i];
      const std::span<const unsigned> corners(face.mIndices, face.mNumIndices);
      if (corners.size() == 1 || corners.size() == 2 || corners.size() == 3)
        problem_.check(indices[corners.size() - 1].append(corners));
      else if (corners.size() > 3)
        addPolygon(mesh, corners, indices[2]);
    }
    for (std::size_t i = 0; i < kModes.size(); ++i)
      if (!indices[i].empty()) {
        part.mode = kModes[i];
        part.indices = keep(std::move(indices[i]), kIndexRows, scene_);
        scene_.parts.push_back(part);
      }
  }

  void addPolygon(const aiMesh &mesh, std::span<const unsigned> corners,
                  ScratchArray<std::uint32_t> &indices) {
    points_.clear();
    for (const unsigned corner : corners) {
      if (corner >= mesh.mNumVertices)
        return problem_.set("a face names vertex " + std::to_string(corner) + ", but there are " +
                            std::to_string(mesh.mNumVertices));
      const aiVector3D &point = mesh.mVertices[corner];
      points_.push_back({point.x, point.y, point.z});
    }
    for (const auto &[a, b, c] : cutter_.cut(points_))
      problem_.check(indices.append(std::array{corners[a], corners[b], corners[c]}));
  }

  void addNode(const aiNode &node, const Transform &parent, std::size_t depth) {
    if (depth == kDeepest)
      return problem_.set("its nodes are more than 1024 deep");
    const Transform place(parent * glm::dmat4(transformOf(node.mTransformation)));
    for (unsigned i = 0; i < node.mNumMeshes && !problem_; ++i)
      if (node.mMeshes[i] < parts_.size())
        for (std::uint32_t part = parts_[node.mMeshes[i]].first; part < parts_[node.mMeshes[i]].end; ++part)
          scene_.instances.push_back({part, place});
    for (unsigned i = 0; i < node.mNumChildren && !problem_; ++i)
      addNode(*node.mChildren[i], place, depth + 1);
  }

  void warn() {
    if (colourScale_.whole() != 1)
      warnings_.add("the colours of vertices are not below 1, and are taken as numbers that count to " +
                    std::to_string(static_cast<std::uint64_t>(colourScale_.whole())));
    if (hasBones_)
      warnings_.add("skins are not applied: the model is read as its nodes place it");
    if (hasMorphs_)
      warnings_.add("morph targets are not applied: the model is read without them");
    if (lacksUvs_)
      warnings_.add("a mesh with a texture has no texture coordinates: its texture is not used");
    if (from_.mNumAnimations != 0)
      warnings_.add("animations are not applied");
    if ((from_.mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
      warnings_.add("assimp has read only some of the file");
    if (cutter_.badFans() != 0)
      warnings_.add(std::to_string(cutter_.badFans()) +
                    " faces of more than 128 corners are not convex and are cut into fans all the same");
  }

  const aiScene &from_;
  const MeshInput &input_;
  Warnings &warnings_;
  TriangleScene scene_;
  Problem problem_;
  AssimpMaterials materials_;
  std::vector<Parts> parts_;
  std::vector<PolygonCutter::Point> points_;
  PolygonCutter cutter_;
  ColourScale colourScale_;
  ColourScale alphaScale_;
  bool hasBones_ = false;
  bool hasMorphs_ = false;
  bool lacksUvs_ = false; ///< A mesh with a texture.
};

} // namespace

Expected<TriangleScene> sceneOf(const aiScene &from, const MeshInput &input, Warnings &warnings) {
  return SceneCopier(from, input, warnings).copy();
}

} // namespace voxc
