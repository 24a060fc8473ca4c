// Loading of mesh files: which reader takes which, and the check of what it made.
#include "voxc/Mesh/TriangleScene.h"

#include "Mesh/Gltf/GltfReader.h"
#include "Mesh/MeshInput.h"
#include "Mesh/NumberCheck.h"
#include "Mesh/Obj/ObjReader.h"
#include "Mesh/Ply/PlyScene.h"
#include "Mesh/Stl/StlReader.h"
#include "Mesh/UnusedVertices.h"

#include <algorithm>
#include <array>
#include <new>

namespace voxc {

namespace {

struct ReaderRow {
  std::string_view ending;
  std::string_view kind;
  Expected<TriangleScene> (*read)(const MeshInput &input);
  bool keepsUnused; ///< Vertices that nothing uses are in the scene.
};

constexpr std::array<ReaderRow, 5> kReaders{{{".obj", "OBJ", readObj, false},
                                             {".ply", "PLY", readPlyScene, true},
                                             {".glb", "glTF", readGltf, true},
                                             {".gltf", "glTF", readGltf, true},
                                             {".stl", "STL", readStl, false}}};

/// Says of which file an error is, unless it says so itself.
Error named(const Error &error, const ReaderRow &reader, const std::string &path) {
  const std::string quoted = "'" + path + "'";
  if (error.kind != ErrorKind::Input || error.message.starts_with(quoted))
    return error;
  return Error::input(quoted + " is not a usable " + std::string(reader.kind) + " file: " + error.message);
}

Expected<TriangleScene> readAndCheck(const ReaderRow &reader, const MeshInput &input) {
  auto scene = reader.read(input);
  if (!scene)
    return named(scene.error(), reader, input.path);
  if (auto checked = checkNumbers(*scene, input); !checked)
    return named(checked.error(), reader, input.path);
  if (reader.keepsUnused)
    if (auto warned = warnOfUnused(*scene, input); !warned)
      return named(warned.error(), reader, input.path);
  return scene;
}

} // namespace

Expected<TriangleScene> loadScene(const std::string &path, const std::shared_ptr<WorkingMemory> &memory,
                                  const Progress &progress, bool withMetal) {
  const std::string ending = pathEnding(path);
  const auto *reader = std::find_if(kReaders.begin(), kReaders.end(),
                                    [&](const ReaderRow &row) { return row.ending == ending; });
  if (reader == kReaders.end())
    return Error::input("'" + path +
                        "' is no kind of mesh that is known; there are .obj .ply .glb .gltf .stl");
  auto file = VOXC_TRY(WatchedFile::open(path, memory));
  try {
    return readAndCheck(*reader, {path, file, memory, progress, withMetal});
  } catch (const std::bad_alloc &) {
    return Error::environment("there is not enough memory to read '" + path + "'");
  }
}

} // namespace voxc
