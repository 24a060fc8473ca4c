// Geometry of an imported scene, each instance of a mesh written out in model space.
#include "Mesh/AssimpMesh.h"

#include "Mesh/AssimpMaterials.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

namespace voxc {

namespace {

/// Notes which material libraries an .obj names in vain: assimp tells only its log.
class NotingIoSystem final : public Assimp::DefaultIOSystem {
public:
  explicit NotingIoSystem(std::vector<std::string> &warnings) : warnings_(warnings) {}

  Assimp::IOStream *Open(const char *file, const char *mode) override {
    Assimp::IOStream *stream = DefaultIOSystem::Open(file, mode);
    if (!stream && std::string_view(file).ends_with(".mtl"))
      warnings_.push_back("the material library '" + std::string(file) + "' cannot be read");
    return stream;
  }

private:
  std::vector<std::string> &warnings_;
};

struct Instance {
  const aiNode *node;
  aiMatrix4x4 toModel;
};

/// Every node with its transform to model space. A loop, for a file may nest its nodes as deep as it likes.
std::vector<Instance> flatten(const aiScene &scene) {
  std::vector<Instance> instances{{scene.mRootNode, scene.mRootNode->mTransformation}};
  for (std::size_t next = 0; next < instances.size(); ++next) {
    const Instance parent = instances[next];
    for (unsigned i = 0; i < parent.node->mNumChildren; ++i) {
      const aiNode *child = parent.node->mChildren[i];
      instances.push_back({child, parent.toModel * child->mTransformation});
    }
  }
  return instances;
}

std::uint32_t packColour(const aiColor4D &colour) {
  std::uint32_t word = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const float value = colour[i] > 0 ? std::fmin(colour[i], 1.0f) : 0;
    word |= static_cast<std::uint32_t>(std::lround(value * 255)) << 8 * i;
  }
  return word;
}

class GeometryReader {
public:
  GeometryReader(const aiScene &scene, std::vector<unsigned> uvSets, TriangleMesh &mesh)
      : scene_(scene), uvSets_(std::move(uvSets)), mesh_(mesh) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      hasColours_ = hasColours_ || scene.mMeshes[i]->HasVertexColors(0);
      hasUvs_ = hasUvs_ || scene.mMeshes[i]->HasTextureCoords(0);
    }
  }

  /// Adds the meshes of a node. What is wrong with them, if anything.
  std::string add(const Instance &instance) {
    for (unsigned i = 0; i < instance.node->mNumMeshes; ++i) {
      const unsigned index = instance.node->mMeshes[i];
      if (index >= scene_.mNumMeshes || scene_.mMeshes[index]->mMaterialIndex >= scene_.mNumMaterials)
        return "a node or mesh refers to something that does not exist";
      const aiMesh &part = *scene_.mMeshes[index];
      const std::size_t base = mesh_.positions.size();
      if (base + part.mNumVertices > std::numeric_limits<std::uint32_t>::max())
        return "its instances have more than 2^32 vertices together";
      addVertices(part, instance.toModel);
      if (!addFaces(part, static_cast<std::uint32_t>(base)))
        return "a face names a vertex that does not exist";
    }
    return {};
  }

private:
  void addVertices(const aiMesh &part, const aiMatrix4x4 &toModel) {
    const aiVector3D *uvs = part.mTextureCoords[0];
    if (const unsigned set = uvSets_[part.mMaterialIndex]; part.HasTextureCoords(set))
      uvs = part.mTextureCoords[set];
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D position = toModel * part.mVertices[i];
      mesh_.positions.push_back({position.x, position.y, position.z});
      if (hasColours_)
        mesh_.colours.push_back(part.HasVertexColors(0) ? packColour(part.mColors[0][i]) : 0xffffffff);
      if (hasUvs_)
        mesh_.uvs.push_back(uvs ? Float2{uvs[i].x, uvs[i].y} : Float2{});
    }
  }

  bool addFaces(const aiMesh &part, std::uint32_t base) {
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace &face = part.mFaces[i];
      if (face.mNumIndices != 3) // Points and lines have no surface.
        continue;
      for (unsigned corner = 0; corner < 3; ++corner)
        if (face.mIndices[corner] >= part.mNumVertices)
          return false;
      mesh_.triangles.push_back(
          {{base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]}, part.mMaterialIndex});
    }
    return true;
  }

  const aiScene &scene_;
  std::vector<unsigned> uvSets_;
  TriangleMesh &mesh_;
  bool hasColours_ = false;
  bool hasUvs_ = false;
};

Expected<TriangleMesh> readScene(const std::string &path) {
  const Error broken = Error::input("'" + path + "' is not a usable mesh: ");
  TriangleMesh mesh;
  Assimp::Importer importer;
  importer.SetIOHandler(new NotingIoSystem(mesh.warnings)); // The importer owns it.
  const aiScene *scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_FlipUVs);
  if (!scene || !scene->mRootNode)
    return Error::input(broken.message + importer.GetErrorString());
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  GeometryReader geometry(*scene, readMaterials(*scene, folder, mesh), mesh);
  for (const Instance &instance : flatten(*scene))
    if (std::string wrong = geometry.add(instance); !wrong.empty())
      return Error::input(broken.message + wrong);
  return mesh;
}

} // namespace

Expected<TriangleMesh> readAssimpMesh(const std::string &path) {
  try {
    return readScene(path);
  } catch (const std::exception &thrown) {
    return Error::input("'" + path + "' is not a usable mesh: " + thrown.what());
  }
}

} // namespace voxc
