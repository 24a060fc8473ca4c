// Parsing the header of a PLY file.
#include "Mesh/Ply/PlyHeader.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <utility>

namespace voxc {

namespace {

struct TypeRow {
  std::string_view name;
  std::string_view sizedName;
  std::uint64_t bytes;
  bool integer;
};

/// In the order of `PlyType`.
constexpr std::array<TypeRow, 8> kTypes{{{"char", "int8", 1, true},
                                         {"uchar", "uint8", 1, true},
                                         {"short", "int16", 2, true},
                                         {"ushort", "uint16", 2, true},
                                         {"int", "int32", 4, true},
                                         {"uint", "uint32", 4, true},
                                         {"float", "float32", 4, false},
                                         {"double", "float64", 8, false}}};

constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> kEncodings{
    {{"ascii", PlyEncoding::Ascii},
     {"binary_little_endian", PlyEncoding::LittleEndian},
     {"binary_big_endian", PlyEncoding::BigEndian}}};

/// No sensible header line is longer; a binary file that only looks like a PLY may have no line end at all.
constexpr std::size_t kMaxLine = 4096;

constexpr std::size_t kMostTextures = 4096;

std::optional<PlyType> parseType(std::string_view name) {
  for (std::size_t i = 0; i < kTypes.size(); ++i)
    if (kTypes[i].name == name || kTypes[i].sizedName == name)
      return static_cast<PlyType>(i);
  return std::nullopt;
}

/// What ends the lines: a carriage return where the first line ends by that alone. Data may begin with a line
/// feed.
char lineEndOf(std::string_view text) {
  const std::size_t end = text.substr(0, kMaxLine).find_first_of("\r\n");
  return end != std::string_view::npos && text[end] == '\r' && !text.substr(end).starts_with("\r\n") ? '\r'
                                                                                                     : '\n';
}

/// Takes the next line off the front of `text`, without blanks behind it.
std::optional<std::string> readLine(std::string_view &text, char lineEnd) {
  const std::size_t length = text.substr(0, kMaxLine).find(lineEnd);
  if (length == std::string_view::npos)
    return std::nullopt;
  std::string line(text.substr(0, length));
  text.remove_prefix(length + 1);
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

std::vector<std::string> splitWords(const std::string &line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(std::move(word));
  return words;
}

bool parseFormat(const std::vector<std::string> &words, PlyHeader &header) {
  if (words.size() != 3 || words[2] != "1.0")
    return false;
  const auto row =
      std::find_if(kEncodings.begin(), kEncodings.end(), [&](const auto &r) { return r.first == words[1]; });
  if (row == kEncodings.end())
    return false;
  header.encoding = row->second;
  return true;
}

bool parseElement(const std::vector<std::string> &words, PlyHeader &header) {
  if (words.size() != 3)
    return false;
  PlyElement element{words[1], 0, {}};
  const char *end = words[2].data() + words[2].size();
  const auto parsed = std::from_chars(words[2].data(), end, element.count);
  header.elements.push_back(std::move(element));
  return parsed.ec == std::errc() && parsed.ptr == end;
}

bool parseProperty(const std::vector<std::string> &words, PlyHeader &header) {
  const bool isList = words.size() == 5 && words[1] == "list";
  if ((words.size() != 3 && !isList) || header.elements.empty())
    return false;
  const auto type = parseType(words[words.size() - 2]);
  const auto countType = isList ? parseType(words[2]) : std::nullopt;
  if (!type || (isList && (!countType || !isInteger(*countType))))
    return false;
  header.elements.back().properties.push_back({words.back(), *type, countType});
  return true;
}

bool skipLine(const std::vector<std::string> &, PlyHeader &) { return true; }

/// Names of images, which MeshLab puts into comments, may have blanks.
void readComment(std::string_view line, PlyHeader &header) {
  const std::string keyword = lowerCase(takeWord(line));
  const std::string word = lowerCase(takeWord(line));
  const bool isComment = keyword == "comment" || keyword == "obj_info";
  if (isComment && (word == "texturefile" || word == "texturefile:") &&
      header.textures.size() < kMostTextures)
    header.textures.emplace_back(trimmed(line));
  header.hasWords = header.hasWords || (isComment && word == "voxc" && trimmed(line) == "words");
}

struct Keyword {
  std::string_view word;
  bool (*parse)(const std::vector<std::string> &words, PlyHeader &header);
};

constexpr std::array<Keyword, 5> kKeywords{{{"format", parseFormat},
                                            {"element", parseElement},
                                            {"property", parseProperty},
                                            {"comment", skipLine},
                                            {"obj_info", skipLine}}};

bool parseLine(const std::string &line, PlyHeader &header) {
  const std::vector<std::string> words = splitWords(line);
  if (words.empty())
    return true;
  readComment(line, header);
  const auto keyword =
      std::find_if(kKeywords.begin(), kKeywords.end(), [&](const Keyword &k) { return k.word == words[0]; });
  return keyword != kKeywords.end() && keyword->parse(words, header);
}

} // namespace

std::uint64_t byteSize(PlyType type) { return kTypes[static_cast<std::size_t>(type)].bytes; }

bool isInteger(PlyType type) { return kTypes[static_cast<std::size_t>(type)].integer; }

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property)
      return i;
  return std::nullopt;
}

const PlyElement *PlyHeader::find(std::string_view element) const {
  for (const PlyElement &e : elements)
    if (lowerCase(e.name) == element)
      return &e;
  return nullptr;
}

bool hasFaces(const PlyHeader &header) {
  const PlyElement *faces = header.find("face");
  const PlyElement *strips = header.find("tristrips");
  return (faces && faces->count != 0) || (strips && strips->count != 0);
}

namespace {

constexpr std::size_t kMostQuoted = 80;

/// A line of words, before the first element, whose first word cannot be meant as one of the format: a
/// comment without its keyword, as Blender 2.47 writes it.
bool isFreeLine(const std::string &line, const PlyHeader &header) {
  constexpr std::array<std::string_view, 6> kBegins{"form", "elem", "prop", "end", "obj_", "ply"};
  std::string_view rest = line;
  const std::string word = lowerCase(takeWord(rest));
  const bool isMeant =
      std::ranges::any_of(kBegins, [&](std::string_view begin) { return word.starts_with(begin); });
  return header.elements.empty() && !isMeant && !trimmed(rest).empty();
}

std::string quoted(const std::string &line) {
  const bool isLong = line.size() > kMostQuoted;
  return "'" + line.substr(0, kMostQuoted) + (isLong ? "...'" : "'");
}

} // namespace

Expected<PlyHeader> readPlyHeader(std::string_view &text) {
  if (const auto encoding = wideEncoding(text); !encoding.empty())
    return Error::input(isWideText(encoding));
  const char lineEnd = lineEndOf(text);
  if (readLine(text, lineEnd) != "ply")
    return Error::input("it does not start with the line 'ply'");
  PlyHeader header;
  bool sawFormat = false;
  for (;;) {
    const std::optional<std::string> line = readLine(text, lineEnd);
    if (!line)
      return Error::input("its header has no line 'end_header'");
    if (*line == "end_header")
      break;
    const bool isRead = parseLine(*line, header);
    if (!isRead && !isFreeLine(*line, header))
      return Error::input("its header has the line " + quoted(*line) +
                          ", which is not a format, element, property or comment of PLY 1.0");
    if (!isRead && header.warnings.empty())
      header.warnings.push_back("its header has the line " + quoted(*line) +
                                ", which is taken for a comment; it should begin with the word 'comment'");
    sawFormat = sawFormat || line->starts_with("format");
  }
  if (!sawFormat)
    return Error::input("its header has no line 'format'");
  return header;
}

} // namespace voxc
