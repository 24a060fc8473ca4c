// Broken and odd mesh files: each ends as the table beside them says, with exactly that message.
#include "voxc/Mesh/TriangleScene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

namespace voxc {
namespace {

const std::string kFolder = VOXC_UNITTESTS_DIR "/Mesh/Corpus/";

/// Outcomes by the file's path below the folder: a line "PATH: OUTCOME" each.
std::map<std::string, std::string> readTable() {
  std::map<std::string, std::string> table;
  std::ifstream file(kFolder + "outcomes.txt");
  for (std::string line; std::getline(file, line);)
    if (const std::size_t colon = line.find(": "); colon != std::string::npos && line[0] != '#')
      table[line.substr(0, colon)] = line.substr(colon + 2);
  return table;
}

std::string withoutFolder(std::string text, const std::string &folder) {
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  return text;
}

/// What loading ends in: an error's message, or the number of primitives and the warnings.
std::string outcomeOf(const std::string &path) {
  const auto scene = loadScene(kFolder + path, WorkingMemory::create(std::uint64_t{64} << 20));
  if (!scene)
    return "error: " + scene.error().message;
  std::uint64_t triangles = 0;
  for (const MeshInstance &instance : scene->instances)
    triangles += scene->parts[instance.part].triangles();
  std::string text = "triangles: " + std::to_string(triangles);
  for (const std::string &warning : scene->warnings)
    text += "; warning: " + warning;
  return text;
}

bool isMesh(const std::filesystem::path &path) {
  const std::string ending = path.extension();
  return ending == ".gltf" || ending == ".glb" || ending == ".obj" || ending == ".ply" || ending == ".stl";
}

TEST(Corpus, EveryFileEndsAsItShould) {
  const std::map<std::string, std::string> table = readTable();
  std::size_t files = 0;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(kFolder)) {
    if (!isMesh(entry.path()))
      continue;
    ++files;
    const std::string path = std::filesystem::relative(entry.path(), kFolder);
    const std::string folder = kFolder + std::filesystem::path(path).parent_path().string() + "/";
    const std::string outcome = withoutFolder(outcomeOf(path), folder);
    const auto expected = table.find(path);
    EXPECT_TRUE(expected != table.end() && expected->second == outcome) << path << ": " << outcome;
  }
  EXPECT_EQ(files, table.size());
}

} // namespace
} // namespace voxc
