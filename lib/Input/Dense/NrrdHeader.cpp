// Fields of NRRD headers: "name: value" lines, each with a reader of its own in a table.
#include "Input/Dense/NrrdHeader.h"

#include "Input/Dense/DenseVolume.h"
#include "Source/GridExtent.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

using Vector = std::array<double, 3>;

/// What the fields say, until all are known.
struct Fields {
  std::optional<SampleType> type;
  std::optional<std::int64_t> dimension;
  std::vector<std::int64_t> sizes;
  std::string encoding;
  std::string endian;
  std::vector<double> spacings;
  std::vector<Vector> directions;
  std::optional<Vector> origin;
  NrrdHeader header;
};

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

/// Takes "(x,y,z)" off the front.
bool takeVector(std::string_view &text, Vector &vector) {
  text = trimmed(text);
  const std::size_t end = text.find(')');
  if (!text.starts_with('(') || end == std::string_view::npos)
    return false;
  std::string_view inside = text.substr(1, end - 1);
  text.remove_prefix(end + 1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? inside.find(',') : inside.size();
    if (comma == std::string_view::npos || !parse(trimmed(inside.substr(0, comma)), vector[axis]) ||
        !std::isfinite(vector[axis]))
      return false;
    inside.remove_prefix(std::min(comma + 1, inside.size()));
  }
  return true;
}

struct TypeName {
  std::string_view name;
  SampleType type;
};

constexpr std::array<TypeName, 32> kTypeNames{
    {{"signed char", SampleType::Int8},    {"int8", SampleType::Int8},
     {"int8_t", SampleType::Int8},         {"uchar", SampleType::Uint8},
     {"unsigned char", SampleType::Uint8}, {"uint8", SampleType::Uint8},
     {"uint8_t", SampleType::Uint8},       {"short", SampleType::Int16},
     {"short int", SampleType::Int16},     {"signed short", SampleType::Int16},
     {"int16", SampleType::Int16},         {"int16_t", SampleType::Int16},
     {"ushort", SampleType::Uint16},       {"unsigned short", SampleType::Uint16},
     {"uint16", SampleType::Uint16},       {"uint16_t", SampleType::Uint16},
     {"int", SampleType::Int32},           {"signed int", SampleType::Int32},
     {"int32", SampleType::Int32},         {"int32_t", SampleType::Int32},
     {"uint", SampleType::Uint32},         {"unsigned int", SampleType::Uint32},
     {"uint32", SampleType::Uint32},       {"uint32_t", SampleType::Uint32},
     {"longlong", SampleType::Int64},      {"long long", SampleType::Int64},
     {"int64", SampleType::Int64},         {"int64_t", SampleType::Int64},
     {"ulonglong", SampleType::Uint64},    {"uint64", SampleType::Uint64},
     {"float", SampleType::Float32},       {"double", SampleType::Float64}}};

bool readType(Fields &fields, std::string_view value) {
  for (const TypeName &row : kTypeNames)
    if (row.name == value)
      fields.type = row.type;
  return fields.type.has_value();
}

bool readDimension(Fields &fields, std::string_view value) {
  return parse(value, fields.dimension.emplace());
}

bool readSizes(Fields &fields, std::string_view value) { return parseAll(value, fields.sizes); }

bool readEncoding(Fields &fields, std::string_view value) {
  fields.encoding = value;
  return value == "raw" || value == "gzip" || value == "gz";
}

bool readEndian(Fields &fields, std::string_view value) {
  fields.endian = value;
  return value == "little" || value == "big";
}

bool readSpacings(Fields &fields, std::string_view value) { return parseAll(value, fields.spacings); }

bool readDirections(Fields &fields, std::string_view value) {
  while (!trimmed(value).empty())
    if (!takeVector(value, fields.directions.emplace_back()))
      return false;
  return true;
}

bool readOrigin(Fields &fields, std::string_view value) {
  return takeVector(value, fields.origin.emplace()) && trimmed(value).empty();
}

bool readDataFile(Fields &fields, std::string_view value) {
  // Several files are written as "LIST", or as a pattern with numbers.
  fields.header.dataFile = value;
  return !value.empty() && !value.starts_with("LIST") && value.find('%') == std::string_view::npos;
}

bool readLineSkip(Fields &fields, std::string_view value) { return parse(value, fields.header.lineSkip); }

bool readByteSkip(Fields &fields, std::string_view value) {
  return parse(value, fields.header.byteSkip) && fields.header.byteSkip >= -1;
}

struct FieldKind {
  std::string_view name;
  bool (*read)(Fields &fields, std::string_view value);
};

/// Fields of other names are left alone.
constexpr std::array<FieldKind, 14> kFields{{{"type", readType},
                                             {"dimension", readDimension},
                                             {"sizes", readSizes},
                                             {"encoding", readEncoding},
                                             {"endian", readEndian},
                                             {"spacings", readSpacings},
                                             {"space directions", readDirections},
                                             {"space origin", readOrigin},
                                             {"data file", readDataFile},
                                             {"datafile", readDataFile},
                                             {"line skip", readLineSkip},
                                             {"lineskip", readLineSkip},
                                             {"byte skip", readByteSkip},
                                             {"byteskip", readByteSkip}}};

Expected<void> readField(Fields &fields, std::string_view line) {
  const std::size_t colon = line.find(':');
  if (line.starts_with('#'))
    return {};
  if (colon == std::string_view::npos)
    return Error::input("its line '" + std::string(line.substr(0, 80)) + "' is no field");
  // "key:=value" is for people.
  if (line.substr(colon).starts_with(":="))
    return {};
  for (const FieldKind &kind : kFields)
    if (kind.name == line.substr(0, colon) && !kind.read(fields, trimmed(line.substr(colon + 1))))
      return Error::input("its field '" + std::string(line.substr(0, 80)) + "' is not one that voxc reads");
  return {};
}

Transform transformOf(const Fields &fields) {
  std::array<Vector, 3> steps{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (fields.directions.size() == 3)
      steps[axis] = fields.directions[axis];
    else if (fields.spacings.size() == 3 && std::isfinite(fields.spacings[axis]))
      steps[axis][axis] = fields.spacings[axis];
  }
  return mapOfSteps(steps, fields.origin.value_or(Vector{steps[0][0] / 2, steps[1][1] / 2, steps[2][2] / 2}));
}

/// Holds the fields against each other.
Expected<NrrdHeader> finish(Fields fields) {
  if (!fields.type || fields.sizes.empty() || fields.encoding.empty())
    return Error::input("its header needs the fields type, dimension, sizes and encoding");
  if (fields.dimension.value_or(0) != 3 || fields.sizes.size() != 3)
    return Error::input("it has " + std::to_string(fields.sizes.size()) + " axes; a volume has three");
  NrrdHeader header = std::move(fields.header);
  constexpr std::int64_t kMost = (std::int64_t{1} << kMaxLog2Extent) + 1;
  for (int axis = 0; axis < 3; ++axis)
    header.extent[axis] = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(fields.sizes[static_cast<std::size_t>(axis)], 0, kMost));
  if (byteSize(*fields.type) > 1 && fields.endian.empty())
    return Error::input("its header needs the field endian, since its samples have more than one byte");
  header.layout = {*fields.type, fields.endian == "big"};
  header.isGzip = fields.encoding != "raw";
  if (header.isGzip && header.byteSkip < 0)
    return Error::input("its byte skip of -1 goes with the encoding raw only");
  header.sampleToModel = transformOf(fields);
  return header;
}

} // namespace

Expected<NrrdHeader> readNrrdHeader(std::string_view &text) {
  if (!text.starts_with("NRRD000"))
    return Error::input("it does not begin with 'NRRD000'");
  Fields fields;
  bool isFirst = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty())
      return finish(std::move(fields));
    if (!std::exchange(isFirst, false))
      if (auto read = readField(fields, line); !read)
        return read.error();
  }
  // A header of its own file may end with the file.
  if (!fields.header.dataFile.empty())
    return finish(std::move(fields));
  return Error::input("no blank line ends its header");
}

} // namespace voxc
