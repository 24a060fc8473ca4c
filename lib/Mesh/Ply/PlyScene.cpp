// Vertices, faces and triangle strips of PLY files.
#include "Mesh/Ply/PlyScene.h"

#include "Mesh/KeptArray.h"
#include "Mesh/Ply/PlyFaceLooks.h"
#include "Mesh/Ply/PlyReader.h"
#include "Mesh/Ply/PlyTextures.h"
#include "Mesh/Ply/PlyVertices.h"
#include "Mesh/Polygon.h"
#include "Support/Problem.h"
#include "Support/Text.h"
#include "Support/Warnings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voxc {

namespace {

const PlyElement kNoElement;
constexpr std::uint64_t kRowsBetweenLooks = 1024;

const PlyElement &elementOf(const PlyHeader &header, std::string_view name) {
  const PlyElement *found = header.find(name);
  return found ? *found : kNoElement;
}

constexpr std::array<std::string_view, 2> kCornerNames{"vertex_indices", "vertex_index"};

/// Has the pages of a mapped file watched while it is read.
class Watch {
public:
  Watch(std::span<const std::byte> bytes, WorkingMemory &memory) : bytes_(bytes), memory_(memory) {
    memory_.watch(bytes_);
  }
  ~Watch() { memory_.unwatch(bytes_); }
  Watch(const Watch &) = delete;
  Watch &operator=(const Watch &) = delete;

private:
  std::span<const std::byte> bytes_;
  WorkingMemory &memory_;
};

std::size_t indexOf(const PlyElement &element, const PlyHeader &header) {
  return static_cast<std::size_t>(&element - header.elements.data());
}

/// Which rows of a file are taken.
enum class RowsRead { All, Vertices, Others };

class SceneBuilder {
public:
  SceneBuilder(const PlyHeader &header, const MeshInput &input)
      : input_(input), header_(header),
        vertices_(header, elementOf(header, "vertex"), input.memory, problem_),
        faces_(elementOf(header, "face")), strips_(elementOf(header, "tristrips")),
        looks_(header, faces_, vertices_.hasUvs(), input.memory, problem_),
        faceCorners_(findList(faces_, kCornerNames)), stripCorners_(findList(strips_, kCornerNames)),
        indices_(input.memory) {}

  /// What the header lacks, or nothing.
  std::string missing() const {
    if (std::string missing = vertices_.missing(); !missing.empty())
      return missing;
    if (faces_.count != 0 && !faceCorners_)
      return "its faces need the list vertex_indices";
    if (strips_.count != 0 && !stripCorners_)
      return "its triangle strips need the list vertex_indices";
    return {};
  }

  /// Looks at all colours before the first is asked for. Errors: those of reading.
  Expected<void> lookAhead(const PlyReader &reader) {
    const auto stopped = [&](std::uint64_t row) -> Expected<void> {
      const bool isStopped = row % kRowsBetweenLooks == 0 && !input_.at(0, 1);
      return isStopped ? Expected<void>(Error::interrupted()) : Expected<void>();
    };
    auto looked = lookAtColours(reader, vertices_.element(), vertices_.colour(), stopped);
    return looked ? lookAtColours(reader, faces_, looks_.colour(), stopped) : looked;
  }

  /// Adds a row.
  void add(const PlyElement &element, std::uint64_t index, const PlyRow &row) {
    if (index % kRowsBetweenLooks == 0 && !input_.at(index, element.count))
      problem_.set(Error::interrupted());
    if (&element == &vertices_.element())
      vertices_.add(row);
    else if (&element == &faces_)
      addFace(index, row);
    else if (&element == &strips_)
      addStrips(index, row.lists[*stripCorners_]);
  }

  /// Adds the rows of all elements, or some of them, from this file, whoever opened it.
  Expected<void> addAll(PlyReader &reader, RowsRead rows) {
    return reader.readRows(
        [&](const PlyElement &element, std::uint64_t index, const PlyRow &row) -> Expected<void> {
          const PlyElement &own = header_.elements[indexOf(element, reader.header())];
          const RowsRead kind = &own == &vertices_.element() ? RowsRead::Vertices : RowsRead::Others;
          if (rows == RowsRead::All || rows == kind)
            add(own, index, row);
          return problem_ ? Expected<void>(problem_.error()) : Expected<void>();
        });
  }

  bool hasFacesFirst() const {
    return faces_.count != 0 && &faces_ < &vertices_.element(); // Elements lie in their order.
  }

  const Problem &problem() const { return problem_; }

  TriangleScene take() {
    TriangleScene scene;
    Warnings warnings;
    MeshPart part;
    vertices_.keepIn(scene, part);
    part.indices = keep(std::move(indices_), kIndexRows, scene);
    addTextures(texturesFor(warnings), input_, scene, warnings, problem_);
    looks_.showInvisible();
    if (!problem_ && looks_.isUsed())
      addPartsByLook(part, looks_, input_.memory, scene, warnings, problem_);
    else if (!problem_)
      addPart(part, scene, warnings);
    warn(warnings);
    scene.warnings = warnings.take();
    return scene;
  }

private:
  /// The header, without textures where nothing says where they lie.
  PlyHeader texturesFor(Warnings &warnings) const {
    PlyHeader header;
    if (vertices_.hasUvs() || looks_.hasUvs())
      header.textures = header_.textures;
    else if (!header_.textures.empty())
      warnings.add("it names the texture '" + header_.textures[0] + "', but has no texture coordinates");
    return header;
  }

  void warn(Warnings &warnings) {
    if (shortFaces_ != 0)
      warnings.add(countedAre(shortFaces_, "face") + " left out, of fewer than three corners");
    if (vertices_.areInvisible() || looks_.areInvisible())
      warnings.add("all colours are wholly transparent, and are taken for opaque");
    if (cutter_.badFans() != 0)
      warnings.add(countedAre(cutter_.badFans(), "face") +
                   " cut into fans, which may cover more, as the corners lie in too tangled a way");
    if (looks_.badFaces() != 0)
      warnings.add(
          countedAre(looks_.badFaces(), "face") +
          " without a texture: it is not there, or there are not as many texture coordinates as corners");
    for (const std::string &sentence : {vertices_.colour().warning(), looks_.colour().warning()})
      if (!sentence.empty())
        warnings.add(sentence);
    PlyUse use(header_);
    vertices_.take(use);
    looks_.take(use);
    use.take(faces_, faceCorners_);
    use.take(strips_, stripCorners_);
    for (std::string &sentence : use.warnings())
      warnings.add(std::move(sentence));
  }

  bool isVertex(double corner) const {
    return corner >= 0 && corner < static_cast<double>(vertices_.element().count);
  }

  void noVertex(const char *what, std::uint64_t index, double corner) {
    problem_.set(std::string(what) + " " + std::to_string(index) + " names vertex " +
                 std::to_string(static_cast<std::int64_t>(std::clamp(corner, -0x1p53, 0x1p53))) +
                 ", but there are " + std::to_string(vertices_.element().count));
  }

  void addFace(std::uint64_t index, const PlyRow &row) {
    const std::vector<double> &corners = row.lists[*faceCorners_];
    for (const double corner : corners)
      if (!isVertex(corner))
        return noVertex("face", index, corner);
    shortFaces_ += corners.size() < 3;
    if (corners.size() < 3)
      return;
    if (looks_.isUsed())
      looks_.read(row, corners.size());
    if (corners.size() == 3)
      return addPiece(corners, {0, 1, 2});
    points_.clear();
    for (const double corner : corners)
      points_.push_back(vertices_.positionOf(static_cast<std::uint64_t>(corner)));
    for (const PolygonCutter::Corners &places : cutter_.cut(points_))
      addPiece(corners, places);
  }

  /// A triangle of a face.
  void addPiece(const std::vector<double> &corners, const std::array<std::uint32_t, 3> &places) {
    addTriangle(corners[places[0]], corners[places[1]], corners[places[2]]);
    if (looks_.isUsed())
      looks_.add(places);
  }

  /// Several strips, with -1 between them.
  void addStrips(std::uint64_t index, const std::vector<double> &corners) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == -1) {
        begin = i + 1;
      } else if (!isVertex(corners[i])) {
        return noVertex("strip", index, corners[i]);
      } else if (i >= begin + 2) {
        const bool isTurned = (i - begin) % 2 != 0; // Every second one of a strip is, as it is stored.
        addTriangle(corners[i - 2 + isTurned], corners[i - 1 - isTurned], corners[i]);
        if (looks_.isUsed())
          looks_.addPlain();
      }
    }
  }

  void addTriangle(double a, double b, double c) {
    const std::array<std::uint32_t, 3> corners{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                               static_cast<std::uint32_t>(c)};
    problem_.check(indices_.append(corners));
  }

  const MeshInput &input_;
  const PlyHeader &header_;
  Problem problem_;
  PlyVertices vertices_;
  const PlyElement &faces_;
  const PlyElement &strips_;
  PlyFaceLooks looks_;
  std::optional<std::size_t> faceCorners_;
  std::optional<std::size_t> stripCorners_;
  ScratchArray<std::uint32_t> indices_;
  std::vector<PolygonCutter::Point> points_;
  PolygonCutter cutter_;
  std::uint64_t shortFaces_ = 0;
};

} // namespace

Expected<TriangleScene> readPlyScene(const MeshInput &input) {
  auto reader = VOXC_TRY(PlyReader::open(input.path));
  SceneBuilder builder(reader.header(), input);
  if (std::string missing = builder.missing(); !missing.empty())
    return reader.broken(missing);
  const Watch watch(reader.bytes(), *input.memory);
  VOXC_TRY(builder.lookAhead(reader));
  // A file may name its faces before its vertices, without which their shape is not known.
  const bool hasFacesFirst = builder.hasFacesFirst();
  Expected<void> read;
  if (hasFacesFirst) {
    auto ahead = VOXC_TRY(reader.reopened());
    read = builder.addAll(ahead, RowsRead::Vertices);
  }
  if (read)
    read = builder.addAll(reader, hasFacesFirst ? RowsRead::Others : RowsRead::All);
  if (builder.problem() && builder.problem().error().kind == ErrorKind::Input)
    return reader.broken(builder.problem().error().message);
  if (!read)
    return read.error();
  TriangleScene scene = builder.take();
  if (const std::uint64_t bytes = reader.bytesBehind(); bytes != 0)
    scene.warnings.push_back(countedAre(bytes, "byte") + " left out, which lie behind the last element");
  return builder.problem() ? Expected<TriangleScene>(builder.problem().error())
                           : Expected<TriangleScene>(std::move(scene));
}

} // namespace voxc
