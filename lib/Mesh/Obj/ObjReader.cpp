// Statements of .obj files.
#include "Mesh/Obj/ObjReader.h"

#include "Mesh/Obj/ObjGeometry.h"
#include "Mesh/Obj/ObjMaterials.h"
#include "Support/Text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

std::uint32_t packColour(std::span<const double> channels) {
  std::uint32_t word = 0xff000000;
  for (std::size_t i = 0; i < 3; ++i) {
    // Written so that NaN becomes 0.
    const double bounded = channels[i] > 0 ? std::fmin(channels[i], 1) : 0;
    word |= static_cast<std::uint32_t>(std::lround(bounded * 255)) << 8 * i;
  }
  return word;
}

class ObjReader {
public:
  explicit ObjReader(const MeshInput &input)
      : input_(input), geometry_(input.memory, problem_), materials_(input, scene_, warnings_, problem_) {}

  Expected<TriangleScene> read() {
    TextLines lines(input_.file->text());
    while (const auto line = lines.next()) {
      if (lines.number() % kLinesBetweenLooks == 0 && !input_.at(lines.done(), input_.file->text().size()))
        return Error::interrupted();
      rest_ = *line;
      readStatement(takeWord(rest_));
      if (problem_)
        return Error{problem_.error().kind,
                     "line " + std::to_string(lines.number()) + ": " + problem_.error().message};
    }
    geometry_.finish(scene_);
    if (problem_)
      return problem_.error();
    warnAboutFaces();
    if (scene_.materials.empty())
      scene_.materials.emplace_back();
    scene_.warnings = warnings_.take();
    scene_.loaderPeakBytes = materials_.libraryPeakBytes();
    return std::move(scene_);
  }

private:
  static constexpr std::uint64_t kLinesBetweenLooks = 256;

  struct Statement {
    std::string_view word;
    void (ObjReader::*read)();
  };

  /// What is not in the table says nothing about the surface: normals, groups, smoothing.
  void readStatement(std::string_view word) {
    static constexpr std::array<Statement, 9> kStatements{{{"v", &ObjReader::readPosition},
                                                           {"vt", &ObjReader::readUv},
                                                           {"f", &ObjReader::readFace},
                                                           {"l", &ObjReader::readLine},
                                                           {"p", &ObjReader::readPoints},
                                                           {"usemtl", &ObjReader::useMaterial},
                                                           {"mtllib", &ObjReader::readLibraries},
                                                           {"curv", &ObjReader::passOver},
                                                           {"surf", &ObjReader::passOver}}};
    const auto *statement = std::find_if(kStatements.begin(), kStatements.end(),
                                         [&](const Statement &s) { return s.word == word; });
    if (statement != kStatements.end())
      (this->*statement->read)();
  }

  /// Reads up to `most` numbers; how many there are.
  std::size_t readNumbers(std::span<double> numbers) {
    std::size_t count = 0;
    for (std::string_view word = takeWord(rest_);
         !word.empty() && !word.starts_with('#') && count < numbers.size(); word = takeWord(rest_)) {
      const auto number = parseNumber(word);
      if (!number) {
        problem_.set("'" + std::string(word.substr(0, 40)) + "' is not a number");
        return count;
      }
      numbers[count++] = *number;
    }
    return count;
  }

  /// x y z, then w, a colour, or both.
  void readPosition() {
    std::array<double, 7> numbers{};
    const std::size_t count = readNumbers(numbers);
    if (count < 3)
      return problem_.set("a vertex has " + std::to_string(count) + " numbers, fewer than three");
    std::optional<std::uint32_t> colour;
    if (count >= 6)
      colour = packColour(std::span(numbers).subspan(count - 3));
    geometry_.addPosition({numbers[0], numbers[1], numbers[2]}, colour);
  }

  void readUv() {
    std::array<double, 3> numbers{};
    if (readNumbers(numbers) == 0)
      problem_.set("a texture coordinate has no number");
    // An .obj counts v from below, the scene from above.
    geometry_.addUv({static_cast<float>(numbers[0]), static_cast<float>(1 - numbers[1])});
  }

  /// "7", "7/8", "7//9" or "7/8/9"; the last is a normal.
  void readCorners() {
    corners_.clear();
    for (std::string_view word = takeWord(rest_); !word.empty() && !word.starts_with('#');
         word = takeWord(rest_)) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      std::string_view uv = word.substr(std::min(slash + 1, word.size()));
      uv = uv.substr(0, uv.find('/'));
      const auto position = parseInteger(word.substr(0, slash));
      const auto uvNumber = uv.empty() ? std::optional<std::int64_t>(0) : parseInteger(uv);
      if (!position || !uvNumber || (*uvNumber == 0 && !uv.empty()))
        return problem_.set("'" + std::string(word.substr(0, 40)) + "' is not a corner");
      corners_.push_back({*position, *uvNumber});
    }
  }

  void add(PrimitiveMode mode) {
    readCorners();
    if (!problem_)
      geometry_.add(mode, corners_, materials_.use(material_));
  }

  void readFace() { add(PrimitiveMode::Triangles); }
  void readLine() { add(PrimitiveMode::Lines); }
  void readPoints() { add(PrimitiveMode::Points); }
  void useMaterial() { material_ = trimmed(rest_); }
  void readLibraries() { materials_.addLibraries(rest_); }

  void passOver() {
    if (!std::exchange(sawFreeForm_, true))
      warnings_.add("free-form curves and surfaces are not read");
  }

  void warnAboutFaces() {
    if (geometry_.shortFaces() != 0)
      warnings_.add(std::to_string(geometry_.shortFaces()) +
                    " faces have fewer than three corners and are left out");
    if (geometry_.badFans() != 0)
      warnings_.add(std::to_string(geometry_.badFans()) +
                    " faces of more than 128 corners are not convex and are cut into fans all the same");
  }

  const MeshInput &input_;
  TriangleScene scene_;
  Warnings warnings_;
  Problem problem_;
  ObjGeometry geometry_;
  ObjMaterials materials_;
  std::string_view rest_; ///< Of the line.
  std::string material_;
  std::vector<ObjCorner> corners_;
  bool sawFreeForm_ = false;
};

} // namespace

Expected<TriangleScene> readObj(const MeshInput &input) { return ObjReader(input).read(); }

} // namespace voxc
