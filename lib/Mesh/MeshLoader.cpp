// Loading of meshes: which reader takes which file, and the check of what it made.
#include "voxc/Mesh/TriangleMesh.h"

#include "Mesh/AssimpMesh.h"
#include "Mesh/MeshCheck.h"
#include "Mesh/PathEnding.h"
#include "Mesh/PlyMesh.h"
#include "voxc/Support/File.h"

namespace voxc {

namespace {

Expected<TriangleMesh> readMesh(const std::string &path) {
  if (pathEnding(path) != ".ply")
    return readAssimpMesh(path);
  auto reader = PlyReader::open(path);
  if (!reader)
    return reader.error();
  return readPlyMesh(*reader);
}

} // namespace

Expected<TriangleMesh> loadMesh(const std::string &path) {
  // Says why a file cannot be read, which assimp does not.
  if (auto file = MappedFile::open(path); !file)
    return file.error();
  Expected<TriangleMesh> mesh = readMesh(path);
  if (!mesh)
    return mesh;
  if (auto checked = checkMesh(*mesh); !checked)
    return Error::input("'" + path + "': " + checked.error().message);
  return mesh;
}

} // namespace voxc
