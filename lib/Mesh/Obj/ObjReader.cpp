// Statements of .obj files.
#include "Mesh/Obj/ObjReader.h"

#include "Mesh/Obj/ObjGeometry.h"
#include "Mesh/Obj/ObjMaterials.h"
#include "Mesh/Obj/VertexNumbers.h"
#include "Mesh/UnusedVertices.h"
#include "Support/Text.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>
#include <vector>

namespace voxc {

namespace {

/// About normals, groups, levels of detail and free-form geometry, of which "curv" and "surf" give notice.
constexpr std::array<std::string_view, 25> kPassedOver{
    "vn",       "g",          "o",         "s",     "mg",    "vp",  "lod",  "bevel", "c_interp",
    "d_interp", "shadow_obj", "trace_obj", "ctech", "stech", "deg", "bmat", "step",  "cstype",
    "parm",     "trim",       "hole",      "scrv",  "sp",    "end", "con"};

template <typename Table> bool contains(const Table &table, std::string_view word) {
  return std::find(table.begin(), table.end(), word) != table.end();
}

constexpr std::string_view kPaint = "#MRGB";

class ObjReader {
public:
  explicit ObjReader(const MeshInput &input)
      : input_(input), geometry_(input.memory, problem_), materials_(input, scene_, warnings_, problem_) {}

  Expected<TriangleScene> read() {
    if (const auto encoding = wideEncoding(input_.file->text()); !encoding.empty())
      return Error::input(isWideText(encoding));
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
    if (geometry_.isBare())
      geometry_.addAllAsPoints(materials_.use(material_));
    geometry_.finish(scene_);
    if (problem_)
      return problem_.error();
    for (MeshPart &part : scene_.parts)
      if (scene_.materials[part.material].emissionTexture.texture >= 0)
        part.emissionUvs = part.uvs;
    warnAboutFaces();
    warnAboutColours();
    warnAboutPaint();
    warnAboutTextures();
    warnAboutStatements();
    if (scene_.materials.empty())
      scene_.materials.emplace_back();
    scene_.warnings = warnings_.take();
    scene_.loaderPeakBytes = materials_.libraryPeakBytes();
    return std::move(scene_);
  }

private:
  static constexpr std::uint64_t kLinesBetweenLooks = 256;
  static constexpr std::size_t kLongestWord = 32;
  static constexpr std::size_t kMostUnknown = 8;

  struct Statement {
    std::string_view word;
    void (ObjReader::*read)();
  };

  /// Programs write the words in letters of any case.
  void readStatement(std::string_view word) {
    if (word == kPaint)
      readPaint();
    if (word.empty() || word.front() == '#' || readKnown(word) || contains(kPassedOver, word))
      return;
    const std::string lower = lowerCase(word.substr(0, kLongestWord));
    if (!readKnown(lower) && !contains(kPassedOver, lower) && unknown_.size() < kMostUnknown)
      unknown_.insert(std::string(word.substr(0, kLongestWord)));
  }

  bool readKnown(std::string_view word) {
    static constexpr std::array<Statement, 11> kStatements{{{"v", &ObjReader::readPosition},
                                                            {"vt", &ObjReader::readUv},
                                                            {"f", &ObjReader::readFace},
                                                            {"fo", &ObjReader::readFace}, // Of old files.
                                                            {"l", &ObjReader::readLine},
                                                            {"p", &ObjReader::readPoints},
                                                            {"usemtl", &ObjReader::useMaterial},
                                                            {"mtllib", &ObjReader::readLibraries},
                                                            {"curv", &ObjReader::passOver},
                                                            {"curv2", &ObjReader::passOver},
                                                            {"surf", &ObjReader::passOver}}};
    const auto *statement = std::find_if(kStatements.begin(), kStatements.end(),
                                         [&](const Statement &s) { return s.word == word; });
    if (statement == kStatements.end())
      return false;
    (this->*statement->read)();
    return true;
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

  /// x y z, then w, a colour, a colour with alpha, or w and a colour.
  void readPosition() {
    std::array<double, 8> numbers{};
    const std::size_t there = readNumbers(numbers), count = std::min<std::size_t>(there, 7);
    // A weight is for curves; that of all else is 1.
    hasSurplus_ = hasSurplus_ || there > 7 || there == 5 || (there == 4 && numbers[3] != 1);
    if (count < 3)
      return problem_.set("a vertex has " + std::to_string(count) + " numbers, fewer than three");
    if (count == 7 && !haveWeights_)
      haveWeights_ = haveWeights(input_.file->text());
    const std::size_t first = count == 7 && *haveWeights_ ? 4 : 3;
    std::optional<ObjGeometry::Colour> colour;
    if (count >= 6)
      colour = {static_cast<float>(numbers[first]), static_cast<float>(numbers[first + 1]),
                static_cast<float>(numbers[first + 2])};
    geometry_.addPosition({numbers[0], numbers[1], numbers[2]}, colour);
  }

  /// Colours that ZBrush hides in comments: MMRRGGBB in hexadecimal digits for each vertex, of which MM is a
  /// mask.
  void readPaint() {
    for (std::string_view words = trimmed(rest_); words.size() >= 8; words.remove_prefix(8)) {
      unsigned word = 0;
      const auto parsed = std::from_chars(words.data(), words.data() + 8, word, 16);
      if (parsed.ptr != words.data() + 8)
        return;
      const auto share = [&](unsigned shift) { return static_cast<float>(word >> shift & 255) / 255; };
      geometry_.paint({share(16), share(8), share(0)});
    }
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
      if (!position || !uvNumber)
        return problem_.set("'" + std::string(word.substr(0, 40)) + "' is not a corner");
      // A 0 that is written names none either.
      constexpr std::int64_t kNowhere = std::numeric_limits<std::int64_t>::max();
      corners_.push_back({*position, *uvNumber == 0 && !uv.empty() ? kNowhere : *uvNumber});
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
      warnings_.add(countedAre(geometry_.shortFaces(), "face") + " left out, of fewer than three corners");
    if (const std::uint64_t unused = geometry_.unusedPositions(); unused != 0)
      warnings_.add(saysUnused(unused));
    if (geometry_.badFans() != 0)
      warnings_.add(countedAre(geometry_.badFans(), "face") +
                    " cut into fans, which may cover more, as the corners lie in too tangled a way");
    if (geometry_.badUvs() != 0)
      warnings_.add("texture coordinates that do not exist are named by " +
                    counted(geometry_.badUvs(), "corner") + " of faces, without a texture there");
  }

  void warnAboutColours() {
    if (hasSurplus_)
      warnings_.add("vertices have numbers beside x, y, z and a colour, which are not used");
    if (haveWeights_ == false)
      warnings_.add("vertices have seven numbers, which are taken as x, y, z, red, green, blue and alpha; "
                    "the alpha is left out");
    const ColourScale &scale = geometry_.colourScale();
    if (scale.whole() != 1)
      warnings_.add("the colours of vertices are not below 1, and are taken as numbers that count to " +
                    std::to_string(static_cast<std::uint64_t>(scale.whole())));
    else if (scale.largest() > 1)
      warnings_.add("some colours of vertices are above 1, and are cut there");
  }

  void warnAboutPaint() {
    if (geometry_.isPaintLate())
      warnings_.add("some colours of comments #MRGB stand behind faces or have no vertex, and are not used");
  }

  bool hasTexture(const MeshPart &part) const {
    const Material &material = scene_.materials[part.material];
    return material.texture.texture >= 0 || material.alphaMask.texture >= 0 ||
           material.emissionTexture.texture >= 0;
  }

  void warnAboutTextures() {
    const bool hasUvs =
        std::ranges::any_of(scene_.parts, [](const MeshPart &part) { return bool(part.uvs); });
    if (!hasUvs && !scene_.textures.empty())
      return warnings_.add("the model has no texture coordinates, and its textures are not used");
    std::uint64_t bare = 0;
    for (const MeshPart &part : scene_.parts)
      bare += !part.uvs && hasTexture(part) ? part.triangles() : 0;
    if (bare != 0)
      warnings_.add(counted(bare, "triangle") + " of materials with textures " +
                    (bare == 1 ? "has" : "have") + " no texture coordinates, and no texture");
  }

  void warnAboutStatements() {
    std::string words;
    for (const std::string &word : unknown_)
      words += (words.empty() ? "'" : ", '") + word + "'";
    if (!words.empty())
      warnings_.add("statements that are not known are passed over: " + words);
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
  std::set<std::string> unknown_; ///< Statements.
  bool sawFreeForm_ = false;
  bool hasSurplus_ = false;         ///< Numbers of vertices.
  std::optional<bool> haveWeights_; ///< Known where a vertex has seven numbers.
};

} // namespace

Expected<TriangleScene> readObj(const MeshInput &input) { return ObjReader(input).read(); }

} // namespace voxc
