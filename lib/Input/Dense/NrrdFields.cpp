// Fields of NRRD headers: "name: value" lines, each with a reader of its own in a table.
#include "Input/Dense/NrrdFields.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

using Fields = NrrdFields;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Takes the first word off the front of `text`.
std::string_view takeWord(std::string_view &text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text.remove_prefix(word.size());
  return word;
}

template <typename Number> bool parse(std::string_view text, Number &number) {
  text.remove_prefix(text.starts_with('+') ? 1 : 0);
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
}

template <typename Number> bool parseAll(std::string_view text, std::vector<Number> &numbers) {
  numbers.clear();
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
    if (!parse(word, numbers.emplace_back()))
      return false;
  return true;
}

/// Takes "(x,y,z)", of as many numbers as there are, or "none" off the front.
bool takeVector(std::string_view &text, std::vector<double> &vector) {
  text = trimmed(text);
  if (text.starts_with("none")) {
    takeWord(text);
    return true;
  }
  const std::size_t end = text.find(')');
  if (!text.starts_with('(') || end == std::string_view::npos)
    return false;
  std::string_view inside = text.substr(1, end - 1);
  text.remove_prefix(end + 1);
  while (true) {
    const std::size_t comma = std::min(inside.find(','), inside.size());
    if (!parse(trimmed(inside.substr(0, comma)), vector.emplace_back()) || !std::isfinite(vector.back()))
      return false;
    if (comma == inside.size())
      return true;
    inside.remove_prefix(comma + 1);
  }
}

struct TypeName {
  std::string_view name;
  SampleType type;
};

constexpr std::array<TypeName, 35> kTypeNames{{{"signed char", SampleType::Int8},
                                               {"int8", SampleType::Int8},
                                               {"int8_t", SampleType::Int8},
                                               {"uchar", SampleType::Uint8},
                                               {"unsigned char", SampleType::Uint8},
                                               {"uint8", SampleType::Uint8},
                                               {"uint8_t", SampleType::Uint8},
                                               {"short", SampleType::Int16},
                                               {"short int", SampleType::Int16},
                                               {"signed short", SampleType::Int16},
                                               {"int16", SampleType::Int16},
                                               {"int16_t", SampleType::Int16},
                                               {"ushort", SampleType::Uint16},
                                               {"unsigned short", SampleType::Uint16},
                                               {"uint16", SampleType::Uint16},
                                               {"uint16_t", SampleType::Uint16},
                                               {"int", SampleType::Int32},
                                               {"signed int", SampleType::Int32},
                                               {"int32", SampleType::Int32},
                                               {"int32_t", SampleType::Int32},
                                               {"uint", SampleType::Uint32},
                                               {"unsigned int", SampleType::Uint32},
                                               {"uint32", SampleType::Uint32},
                                               {"uint32_t", SampleType::Uint32},
                                               {"long long", SampleType::Int64},
                                               {"int64", SampleType::Int64},
                                               {"int64_t", SampleType::Int64},
                                               {"ulonglong", SampleType::Uint64},
                                               {"uint64", SampleType::Uint64},
                                               {"uint64_t", SampleType::Uint64},
                                               {"unsigned long long", SampleType::Uint64},
                                               {"signed long long", SampleType::Int64},
                                               {"longlong", SampleType::Int64},
                                               {"float", SampleType::Float32},
                                               {"double", SampleType::Float64}}};

bool readType(Fields &fields, std::string_view value) {
  // "unsigned short int" is "unsigned short".
  std::string name = lowerCase(value);
  if (name.ends_with(" int") && name != "signed int" && name != "unsigned int")
    name.resize(name.size() - 4);
  for (const TypeName &row : kTypeNames)
    if (row.name == name)
      fields.type = row.type;
  return fields.type.has_value();
}

bool readDimension(Fields &fields, std::string_view value) {
  return parse(value, fields.dimension.emplace());
}

bool readSizes(Fields &fields, std::string_view value) { return parseAll(value, fields.sizes); }

struct EncodingName {
  std::string_view name;
  NrrdEncoding encoding;
};

constexpr std::array<EncodingName, 9> kEncodings{{{"raw", NrrdEncoding::Raw},
                                                  {"gzip", NrrdEncoding::Gzip},
                                                  {"gz", NrrdEncoding::Gzip},
                                                  {"bzip2", NrrdEncoding::Bzip2},
                                                  {"bz2", NrrdEncoding::Bzip2},
                                                  {"text", NrrdEncoding::Text},
                                                  {"txt", NrrdEncoding::Text},
                                                  {"ascii", NrrdEncoding::Text},
                                                  {"hex", NrrdEncoding::Hex}}};

bool readEncoding(Fields &fields, std::string_view value) {
  const std::string name = lowerCase(value);
  for (const EncodingName &row : kEncodings)
    if (row.name == name)
      fields.encoding = row.encoding;
  return fields.encoding.has_value();
}

bool readEndian(Fields &fields, std::string_view value) {
  fields.endian = lowerCase(value);
  return fields.endian == "little" || fields.endian == "big";
}

bool readSpace(Fields &fields, std::string_view value) {
  fields.space = lowerCase(value);
  return true;
}

bool readSpacings(Fields &fields, std::string_view value) { return parseAll(value, fields.spacings); }

bool readMins(Fields &fields, std::string_view value) { return parseAll(value, fields.mins); }
bool readMaxs(Fields &fields, std::string_view value) { return parseAll(value, fields.maxs); }

bool readCenters(Fields &fields, std::string_view value) {
  fields.centers.clear();
  for (std::string_view word = takeWord(value); !word.empty(); word = takeWord(value))
    fields.centers.push_back(lowerCase(word));
  return true;
}

bool readDirections(Fields &fields, std::string_view value) {
  fields.directions.clear();
  while (!trimmed(value).empty())
    if (!takeVector(value, fields.directions.emplace_back()))
      return false;
  return true;
}

bool readOrigin(Fields &fields, std::string_view value) {
  fields.origin.clear();
  return takeVector(value, fields.origin) && trimmed(value).empty();
}

bool readKinds(Fields &fields, std::string_view value) {
  fields.kinds.clear();
  for (std::string_view word = takeWord(value); !word.empty(); word = takeWord(value))
    fields.kinds.push_back(lowerCase(word));
  return true;
}

/// Words in quotation marks, or without.
bool readUnits(Fields &fields, std::string_view value) {
  fields.units.clear();
  for (std::string_view word = takeWord(value); !word.empty(); word = takeWord(value)) {
    std::string unit(word);
    std::erase(unit, '"');
    fields.units.push_back(std::move(unit));
  }
  return true;
}

bool readDataFile(Fields &fields, std::string_view value) {
  fields.dataFile = value;
  return !value.empty();
}

bool readLineSkip(Fields &fields, std::string_view value) { return parse(value, fields.lineSkip); }

bool readByteSkip(Fields &fields, std::string_view value) {
  return parse(value, fields.byteSkip) && fields.byteSkip >= -1;
}

/// What changes no voxel: descriptions, and how other programs look at the samples.
bool leaveOut(Fields &, std::string_view) { return true; }

struct FieldKind {
  std::string_view name; ///< Without blanks, in lower case: both "data file" and "datafile" are written.
  bool (*read)(Fields &fields, std::string_view value);
};

constexpr std::array kFields{FieldKind{"type", readType},
                             FieldKind{"dimension", readDimension},
                             FieldKind{"sizes", readSizes},
                             FieldKind{"encoding", readEncoding},
                             FieldKind{"endian", readEndian},
                             FieldKind{"space", readSpace},
                             FieldKind{"spacings", readSpacings},
                             FieldKind{"axismins", readMins},
                             FieldKind{"axismaxs", readMaxs},
                             FieldKind{"spacedirections", readDirections},
                             FieldKind{"spaceorigin", readOrigin},
                             FieldKind{"spaceunits", readUnits},
                             FieldKind{"kinds", readKinds},
                             FieldKind{"datafile", readDataFile},
                             FieldKind{"lineskip", readLineSkip},
                             FieldKind{"byteskip", readByteSkip},
                             FieldKind{"spacedimension", leaveOut},
                             FieldKind{"content", leaveOut},
                             FieldKind{"number", leaveOut},
                             FieldKind{"min", leaveOut},
                             FieldKind{"max", leaveOut},
                             FieldKind{"oldmin", leaveOut},
                             FieldKind{"oldmax", leaveOut},
                             FieldKind{"labels", leaveOut},
                             FieldKind{"units", leaveOut},
                             FieldKind{"sampleunits", leaveOut},
                             FieldKind{"thicknesses", leaveOut},
                             FieldKind{"centers", readCenters},
                             FieldKind{"centerings", readCenters},
                             FieldKind{"measurementframe", leaveOut}};

/// Which readers of fields had one; two names may have the same reader.
using Seen = std::array<bool, kFields.size()>;

/// Whether a field that is used was there before, under this name or another.
bool wasSeen(const FieldKind &kind, Seen &seen) {
  const auto row = std::ranges::find(kFields, kind.read, &FieldKind::read) - kFields.begin();
  return kind.read != leaveOut && std::exchange(seen[static_cast<std::size_t>(row)], true);
}

Expected<void> readField(Fields &fields, std::string_view line, Seen &seen) {
  if (line.starts_with('#'))
    return {};
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos)
    return Error::input("its line '" + std::string(line.substr(0, 80)) + "' is no field");
  // "key:=value" is for people, but for the segments that 3D Slicer lists.
  if (line.substr(colon).starts_with(":=")) {
    fields.hasSegments |= line.starts_with("Segment0_") || line.starts_with("Segmentation_");
    fields.keys.emplace_back(line.substr(0, std::min<std::size_t>(colon, 80)));
    return {};
  }
  std::string name = lowerCase(line.substr(0, colon));
  std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
  const auto *const kind = std::ranges::find(kFields, name, &FieldKind::name);
  if (kind == kFields.end()) {
    fields.unknown.emplace_back(line.substr(0, std::min<std::size_t>(colon, 80)));
    return {};
  }
  if (wasSeen(*kind, seen))
    fields.twice.emplace_back(line.substr(0, colon));
  if (!kind->read(fields, trimmed(line.substr(colon + 1))))
    return Error::input("its field '" + std::string(line.substr(0, 80)) + "' is not one that voxc reads");
  return {};
}

/// What ends the lines: a carriage return where the first line ends by that alone. Samples may begin with a
/// line feed.
char lineEndOf(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view rest = text.substr(end);
  return rest.starts_with('\r') && !rest.starts_with("\r\n") ? '\r' : '\n';
}

/// Takes a line off the front.
std::string_view takeLine(std::string_view &text, char lineEnd) {
  const std::size_t end = std::min(text.find(lineEnd), text.size());
  const std::string_view line = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// The names of files, one a line, up to the end of the header.
void readList(Fields &fields, std::string_view &text, char lineEnd) {
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    if (line.empty())
      return;
    fields.dataFiles.emplace_back(line);
  }
}

} // namespace

Expected<NrrdFields> readNrrdFields(std::string_view &text) {
  if (!text.starts_with("NRRD000"))
    return Error::input("it does not begin with 'NRRD000'");
  Fields fields;
  Seen seen{};
  const char lineEnd = lineEndOf(text);
  takeLine(text, lineEnd);
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    if (line.empty())
      return fields;
    VOXC_TRY(readField(fields, line, seen));
    if (fields.dataFile.starts_with("LIST") && fields.dataFiles.empty()) {
      readList(fields, text, lineEnd);
      return fields;
    }
  }
  // A header of its own file may end with the file.
  if (!fields.dataFile.empty())
    return fields;
  return Error::input("no blank line ends its header");
}

} // namespace voxc
