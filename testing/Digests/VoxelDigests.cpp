// Voxels of scenes, of meshes in every encoding of their numbers, and of points.
#include "testing/Digests/Digest.h"
#include "testing/HardRays/RandomSource.h"
#include "testing/HardScenes.h"

#include "Image/ImageDecoder.h"
#include "Input/Points/PointSource.h"
#include "Mesh/Obj/ObjReader.h"
#include "Mesh/Ply/PlyScene.h"
#include "Mesh/Stl/StlReader.h"
#include "Source/Builtin/Scenes.h"
#include "voxc/Mesh/MeshSource.h"
#include "voxc/Mesh/SolidMesh.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <tuple>
#include <utility>

namespace voxc {

/// Readers of images need libraries that are not at hand for every processor, and no input here has one.
Expected<DecodedImage> ImageDecoder::decode(std::span<const std::byte>) {
  return Error::input("images are not read here");
}

} // namespace voxc

namespace voxc::test {

Expected<std::uint64_t> digestOf(VoxelSource &source) {
  constexpr int kLog2Side = 3;
  const Int3 extent = source.extent();
  Checksum checksum;
  checksum.add(&extent, sizeof extent);
  std::array<std::uint32_t, 512> words;
  int log2Cells = 0;
  while (((1 << kLog2Side) << log2Cells) < std::max({extent.x, extent.y, extent.z}))
    ++log2Cells;
  for (std::uint64_t code = 0; code < std::uint64_t{1} << (3 * log2Cells); ++code) {
    const Cube cube{mortonCell(code << 3 * kLog2Side), kLog2Side};
    if (source.empty(cube))
      continue;
    if (Expected<void> read = source.read(cube, words.data()); !read)
      return read.error();
    checksum.add(&code, sizeof code);
    checksum.add(words.data(), sizeof words);
  }
  return checksum.digest();
}

namespace {

using Corner = std::array<double, 3>;

/// Where models lie: at the origin, and where maps have them.
struct Place {
  const char *name;
  Corner origin;
};
constexpr std::array<Place, 2> kPlaces{
    {{"at the origin", {0, 0, 0}}, {"in UTM", {500123.45, 200.25, 5412345.65}}}};

/// Corners that are whole multiples of 0.0001, as text has them.
std::vector<Corner> randomCorners(RandomSource &random, const Corner &origin, int triangles) {
  std::vector<Corner> corners;
  for (int i = 0; i < triangles; ++i) {
    Corner middle;
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] = origin[axis] + random.integer(0, 100000) * 1e-4;
    const int size = 1 << random.integer(8, 15);
    for (int corner = 0; corner < 3; ++corner) {
      Corner at = middle;
      for (double &coordinate : at)
        coordinate += random.integer(-size, size) * 1e-4;
      corners.push_back(at);
    }
  }
  return corners;
}

std::string lineOf(const char *word, const Corner &corner) {
  char line[128];
  std::snprintf(line, sizeof line, "%s%.4f %.4f %.4f\n", word, corner[0], corner[1], corner[2]);
  return line;
}

std::string objOf(const std::vector<Corner> &corners) {
  std::string text;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    text += lineOf("v ", corners[i]);
    if (i % 3 == 2)
      text += "f -3 -2 -1\n";
  }
  return text;
}

std::string stlOf(const std::vector<Corner> &corners) {
  std::string text = "solid s\n";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0)
      text += "facet normal 0 0 0\nouter loop\n";
    text += lineOf("vertex ", corners[i]);
    if (i % 3 == 2)
      text += "endloop\nendfacet\n";
  }
  return text + "endsolid s\n";
}

std::string plyOf(const std::vector<Corner> &corners, bool hasFaces) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(corners.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  if (hasFaces)
    text +=
        "element face " + std::to_string(corners.size() / 3) + "\nproperty list uchar int vertex_indices\n";
  text += "end_header\n";
  for (const Corner &corner : corners)
    text += lineOf("", corner);
  for (std::size_t i = 0; hasFaces && i < corners.size(); i += 3)
    text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  return text;
}

/// The files of this program, which are removed with it.
class Folder {
public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "voxc-digests-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder &) = delete;
  Folder &operator=(const Folder &) = delete;

  Expected<std::string> write(const std::string &name, const std::string &content) const {
    const std::string path = path_ + "/" + name;
    if (Expected<void> written = writeFile(path, content); !written)
      return written.error();
    return path;
  }

private:
  std::string path_;
};

using ReadMesh = Expected<TriangleScene> (*)(const MeshInput &input);

Expected<std::shared_ptr<const TriangleScene>> loaded(ReadMesh read, const std::string &path,
                                                      const std::shared_ptr<WorkingMemory> &memory) {
  auto file = WatchedFile::open(path, memory);
  if (!file)
    return file.error();
  Expected<TriangleScene> scene = read({path, *file, memory, {}});
  if (!scene)
    return scene.error();
  return std::make_shared<const TriangleScene>(std::move(*scene));
}

class VoxelDigests {
public:
  explicit VoxelDigests(std::vector<NamedDigest> &digests) : digests_(digests) {}

  Expected<void> addScenes() {
    using Make = std::unique_ptr<VoxelSource> (*)(int side);
    for (const auto &[name, make] : {std::pair<const char *, Make>{"terrain", makeTerrain},
                                     {"shell", makeShell},
                                     {"menger", makeMenger},
                                     {"dust", makeDust}})
      if (Expected<void> added = add(std::string("scene ") + name, make(96)); !added)
        return added;
    for (const HardScene &scene : hardScenes({64, 64, 64}))
      if (Expected<void> added = add("hard scene " + scene.name, scene.source()); !added)
        return added;
    return {};
  }

  Expected<void> addModels() {
    for (const Place &place : kPlaces) {
      RandomSource random(7);
      const std::vector<Corner> corners = randomCorners(random, place.origin, 400);
      const std::string where = std::string(" ") + place.name;
      for (const auto &[name, content, read] :
           {std::tuple<const char *, std::string, ReadMesh>{"a.obj", objOf(corners), readObj},
            {"a.stl", stlOf(corners), readStl},
            {"a.ply", plyOf(corners, true), readPlyScene}})
        if (Expected<void> added = addMesh(name + where, name, content, read); !added)
          return added;
      if (Expected<void> added = addPoints("points.ply" + where, plyOf(corners, false)); !added)
        return added;
    }
    return {};
  }

private:
  Expected<std::uint64_t> digest(Expected<std::unique_ptr<VoxelSource>> source) const {
    if (!source)
      return source.error();
    return digestOf(**source);
  }

  Expected<void> add(const std::string &name, Expected<std::unique_ptr<VoxelSource>> source) {
    const Expected<std::uint64_t> value = digest(std::move(source));
    if (!value)
      return value.error();
    digests_.push_back({name, *value});
    return {};
  }

  /// By both voxelizers, which must agree, by each coverage, turned, cropped, and filled.
  Expected<void> addMesh(const std::string &name, const char *file, const std::string &content,
                         ReadMesh read) {
    const auto path = folder_.write(file, content);
    if (!path)
      return path.error();
    const auto scene = loaded(read, *path, memory_);
    if (!scene)
      return scene.error();
    for (const Coverage coverage : {Coverage::Conservative, Coverage::Thin, Coverage::Inner})
      for (const bool zUp : {false, true}) {
        VoxelizeOptions options;
        options.resolution = zUp ? 61 : 64;
        options.zUp = zUp;
        options.coverage = coverage;
        const auto quick = digest(makeMeshSource(*scene, options, memory_));
        const auto simple = digest(makeReferenceMeshSource(**scene, options));
        if (!quick || !simple)
          return quick ? simple.error() : quick.error();
        if (*quick != *simple)
          return Error::input("the voxelizers differ on " + name);
        const std::string rule(kCoverageNames[static_cast<std::size_t>(coverage)]);
        digests_.push_back({name + (zUp ? ", turned, " : ", ") + rule, *quick});
      }
    return addFilled(name, **scene, *scene);
  }

  Expected<void> addFilled(const std::string &name, const TriangleScene &scene,
                           const std::shared_ptr<const TriangleScene> &shared) {
    VoxelizeOptions options;
    options.resolution = 50;
    auto surface = makeMeshSource(shared, options, memory_);
    if (!surface)
      return surface.error();
    Expected<SolidMesh> solid = fillMesh(scene, options, std::move(*surface), 0xff010203);
    if (!solid)
      return solid.error();
    return add(name + ", filled", std::move(solid->source));
  }

  Expected<void> addPoints(const std::string &name, const std::string &content) {
    const auto path = folder_.write("points.ply", content);
    if (!path)
      return path.error();
    for (const int resolution : {8, 63, 200}) {
      auto reader = PlyReader::open(*path);
      if (!reader)
        return reader.error();
      InputOptions options;
      options.resolution = resolution;
      options.memory = memory_;
      auto points = readPoints(*reader, options);
      if (!points)
        return points.error();
      if (auto added = add(name + ", " + std::to_string(resolution), std::move(points->source)); !added)
        return added;
    }
    return {};
  }

  std::vector<NamedDigest> &digests_;
  Folder folder_;
  std::shared_ptr<WorkingMemory> memory_ = WorkingMemory::create(std::uint64_t{256} << 20);
};

} // namespace

Expected<void> addVoxelDigests(std::vector<NamedDigest> &digests) {
  VoxelDigests voxels(digests);
  if (Expected<void> added = voxels.addScenes(); !added)
    return added;
  return voxels.addModels();
}

} // namespace voxc::test
