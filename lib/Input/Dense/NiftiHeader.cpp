// NIfTI headers: where each version keeps its fields, and what they mean together.
#include "Input/Dense/NiftiHeader.h"

#include "Input/Dense/DenseVolume.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace voxc {

namespace {

using Vector = std::array<double, 3>;
using Steps = std::array<Vector, 3>;

/// Bytes from the front of the header to each field.
struct FieldOffsets {
  std::size_t bytes;
  std::size_t magic;
  std::size_t datatype;
  std::size_t dim;
  std::size_t pixdim;
  std::size_t dataOffset;
  std::size_t slope;
  std::size_t intercept;
  std::size_t qformCode;
  std::size_t sformCode;
  std::size_t quaternion;
  std::size_t qoffset;
  std::size_t srow;
  std::size_t units;
  std::size_t intent;
};

constexpr FieldOffsets kVersion1{348, 344, 70, 40, 76, 108, 112, 116, 252, 254, 256, 268, 280, 123, 68};
constexpr FieldOffsets kVersion2{540, 4, 12, 16, 104, 168, 176, 184, 344, 348, 352, 376, 400, 500, 504};

/// Numbers of a header of either version and byte order.
class Reader {
public:
  Reader(std::span<const std::byte> bytes, bool swaps, bool isVersion1)
      : bytes_(bytes), swaps_(swaps), isVersion1_(isVersion1) {}

  const FieldOffsets &at() const { return isVersion1_ ? kVersion1 : kVersion2; }

  std::int64_t datatype() const { return load<std::int16_t>(at().datatype); }
  std::int64_t dim(std::size_t i) const {
    return isVersion1_ ? load<std::int16_t>(at().dim + 2 * i) : load<std::int64_t>(at().dim + 8 * i);
  }
  std::int64_t code(std::size_t offset) const {
    return isVersion1_ ? load<std::int16_t>(offset) : load<std::int32_t>(offset);
  }
  /// Number `i` of an array of numbers.
  double number(std::size_t offset, std::size_t i = 0) const {
    return isVersion1_ ? load<float>(offset + 4 * i) : load<double>(offset + 8 * i);
  }
  /// What the three lowest bits of the byte of units say of lengths.
  unsigned lengthUnit() const {
    return isVersion1_ ? std::to_integer<unsigned>(bytes_[at().units]) & 7
                       : static_cast<unsigned>(load<std::int32_t>(at().units)) & 7;
  }
  double dataOffset() const {
    return isVersion1_ ? load<float>(at().dataOffset)
                       : static_cast<double>(load<std::int64_t>(at().dataOffset));
  }
  bool hasMagic(std::string_view magic) const {
    return std::memcmp(bytes_.data() + at().magic, magic.data(), magic.size()) == 0;
  }

private:
  template <typename Stored> Stored load(std::size_t offset) const {
    std::array<std::byte, sizeof(Stored)> raw;
    std::memcpy(raw.data(), bytes_.data() + offset, raw.size());
    if (swaps_)
      std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Stored>(raw);
  }

  std::span<const std::byte> bytes_;
  bool swaps_;
  bool isVersion1_;
};

struct TypeCode {
  std::int64_t code;
  SampleType type;
  int channels = 1;
};

constexpr std::array<TypeCode, 12> kTypes{{{128, SampleType::Uint8, 3},
                                           {2304, SampleType::Uint8, 4},
                                           {2, SampleType::Uint8},
                                           {4, SampleType::Int16},
                                           {8, SampleType::Int32},
                                           {16, SampleType::Float32},
                                           {64, SampleType::Float64},
                                           {256, SampleType::Int8},
                                           {512, SampleType::Uint16},
                                           {768, SampleType::Uint32},
                                           {1024, SampleType::Int64},
                                           {1280, SampleType::Uint64}}};

/// The steps of the rotation that a unit quaternion's last three numbers stand for.
Steps rotationOf(const Vector &bcd) {
  auto [b, c, d] = bcd;
  const double squares = b * b + c * c + d * d;
  // Of half a turn, where the root would make much of the rounding of float32 (as the format's own library
  // has it).
  const bool isHalfTurn = 1 - squares < 1e-7;
  const double a = isHalfTurn ? 0 : std::sqrt(1 - squares);
  if (isHalfTurn)
    for (double *const part : {&b, &c, &d})
      *part /= std::sqrt(squares);
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
           {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
           {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c}}};
}

/// The map by the header's rotation and sizes of samples.
Transform mapByRotation(const Reader &reader, const Vector &sizes) {
  const FieldOffsets &at = reader.at();
  Vector quaternion;
  Vector origin;
  for (std::size_t i = 0; i < 3; ++i) {
    quaternion[i] = reader.number(at.quaternion, i);
    origin[i] = reader.number(at.qoffset, i);
  }
  Steps steps = rotationOf(quaternion);
  const double handedness = reader.number(at.pixdim) < 0 ? -1 : 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double &component : steps[axis])
      component *= axis == 2 ? sizes[axis] * handedness : sizes[axis];
  return mapOfSteps(steps, origin);
}

/// The map by three rows of a matrix.
Transform mapByMatrix(const Reader &reader) {
  Steps steps;
  Vector origin;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps[axis][row] = reader.number(reader.at().srow, 4 * row + axis);
    origin[row] = reader.number(reader.at().srow, 4 * row + 3);
  }
  return mapOfSteps(steps, origin);
}

/// The map of a form that the header has; none, with a warning, if it puts all samples onto a plane, or
/// nowhere.
std::optional<Transform> usableForm(const char *name, const Transform &map, NiftiHeader &header) {
  if (isFinite(map) && glm::determinant(glm::dmat3(map)) != 0)
    return map;
  header.warnings.push_back("its " + std::string(name) + " is no map of a volume, and is left out");
  return std::nullopt;
}

/// Two maps that tell different places: the matrix is taken.
void compareMaps(const Transform &matrix, const Transform &rotation, const Vector &sizes,
                 NiftiHeader &header) {
  constexpr double kSame = 1e-3;
  const double size = std::max({sizes[0], sizes[1], sizes[2]});
  double most = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      most = std::max(most, std::abs(rotation[column][row] - matrix[column][row]));
  if (!(most <= kSame * size))
    header.warnings.emplace_back("its qform puts the samples elsewhere than its sform, which is taken");
}

/// The sizes of samples; 1 along axes of which the header says none, as other readers have it.
Vector sizesOf(const Reader &reader) {
  Vector sizes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = std::abs(reader.number(reader.at().pixdim, axis + 1));
    sizes[axis] = size > 0 && std::isfinite(size) ? size : 1;
  }
  return sizes;
}

void readMap(const Reader &reader, NiftiHeader &header) {
  const Vector sizes = sizesOf(reader);
  std::optional<Transform> matrix, rotation;
  if (!header.isAnalyze && reader.code(reader.at().sformCode) > 0)
    matrix = usableForm("sform", mapByMatrix(reader), header);
  if (!header.isAnalyze && reader.code(reader.at().qformCode) > 0)
    rotation = usableForm("qform", mapByRotation(reader, sizes), header);
  header.hasOrientation = matrix || rotation;
  const Transform scale = transformOfRows({sizes[0], 0, 0, 0, 0, sizes[1], 0, 0, 0, 0, sizes[2], 0});
  header.sampleToModel = matrix ? *matrix : rotation.value_or(scale);
  if (matrix && rotation)
    compareMaps(*matrix, *rotation, sizes, header);
}

/// Colours and labels by what the file is meant for.
void readIntent(const Reader &reader, NiftiHeader &header) {
  constexpr std::int64_t kLabel = 1002, kRgb = 2003, kRgba = 2004;
  constexpr std::array<double, 4> kUnits{0, 1, 1e-3, 1e-6};
  if (header.isAnalyze)
    return;
  const unsigned unit = reader.lengthUnit();
  header.unit = unit < kUnits.size() ? kUnits[unit] : 0;
  const std::int64_t intent = reader.code(reader.at().intent);
  header.areLabels = intent == kLabel;
  const int channels = intent == kRgb ? 3 : intent == kRgba ? 4 : 1;
  if (channels > 1 && header.volumes == static_cast<std::uint64_t>(channels)) {
    header.channels = channels;
    header.arePlanes = true;
    header.volumes = 1;
  }
}

Expected<void> readDimensions(const Reader &reader, NiftiHeader &header) {
  constexpr std::int64_t kMost = std::int64_t{1} << kMaxLog2Extent;
  const std::int64_t count = reader.dim(0);
  if (count < 1 || count > 7)
    return Error::input("it has " + std::to_string(count) + " axes; there may be 1 to 7");
  header.extent = {1, 1, 1};
  for (std::int64_t i = 1; i <= count; ++i) {
    const std::int64_t size = reader.dim(static_cast<std::size_t>(i));
    if (size < 1 || (i <= 3 && size > kMost) || header.volumes > std::uint64_t{1} << 40)
      return Error::input("axis " + std::to_string(i) + " has " + std::to_string(size) +
                          " samples, which no volume has");
    if (i <= 3)
      header.extent[static_cast<int>(i) - 1] = static_cast<std::int32_t>(size);
    else
      header.volumes *= static_cast<std::uint64_t>(std::min(size, kMost));
  }
  return {};
}

/// A slope of 0 means that nothing is scaled.
Expected<void> readScale(const Reader &reader, NiftiHeader &header) {
  const double slope = reader.number(reader.at().slope);
  const double intercept = reader.number(reader.at().intercept);
  if (slope == 0 || std::isnan(slope))
    return {};
  if (!std::isfinite(slope) || !std::isfinite(intercept))
    return Error::input("its samples are scaled by a number that is not finite");
  header.slope = slope;
  header.intercept = intercept;
  return {};
}

Expected<void> readDataOffset(const Reader &reader, NiftiHeader &header) {
  // Notes may stand between header and samples; they are not that long.
  constexpr double kMost = 1 << 26;
  const double offset = reader.dataOffset();
  const double least = header.isPair ? 0 : static_cast<double>(reader.at().bytes);
  if (!(offset >= least && offset <= kMost))
    return Error::input("its samples begin at byte " + std::to_string(offset) +
                        ", which is inside the header or too far behind it");
  header.dataOffset = static_cast<std::uint64_t>(offset);
  return {};
}

/// Four bytes behind the header say whether others follow, of which each program knows its own.
void readExtensions(std::span<const std::byte> bytes, const Reader &reader, NiftiHeader &header) {
  const std::size_t mark = reader.at().bytes;
  if (!header.isAnalyze && bytes.size() > mark && bytes[mark] != std::byte{0} &&
      (header.isPair || header.dataOffset > mark + 4))
    header.warnings.emplace_back("extensions of its header are not used");
}

Expected<NiftiHeader> readFields(std::span<const std::byte> bytes, const Reader &reader, bool isBigEndian,
                                 NiftiHeader header) {
  const std::int64_t code = reader.datatype();
  const auto *const type = std::ranges::find(kTypes, code, &TypeCode::code);
  if (type == kTypes.end())
    return Error::input("its samples are of the type " + std::to_string(code) +
                        ", which is neither a number of 8 to 64 bits nor a colour of bytes");
  header.layout = {type->type, isBigEndian};
  header.channels = type->channels;
  VOXC_TRY(readDimensions(reader, header));
  if (!header.isAnalyze && header.channels == 1)
    VOXC_TRY(readScale(reader, header));
  VOXC_TRY(readDataOffset(reader, header));
  readMap(reader, header);
  readIntent(reader, header);
  readExtensions(bytes, reader, header);
  return header;
}

} // namespace

Expected<std::uint64_t> NiftiHeader::volumeBytes() const {
  const auto bytes = sampleBytes(extent, layout);
  return bytes ? Expected<std::uint64_t>(*bytes * static_cast<std::uint64_t>(channels)) : bytes;
}

Expected<NiftiHeader> readNiftiHeader(std::span<const std::byte> bytes, bool allowsAnalyze) {
  std::uint32_t size = 0;
  if (bytes.size() >= sizeof size)
    std::memcpy(&size, bytes.data(), sizeof size);
  const bool swaps = size == __builtin_bswap32(348) || size == __builtin_bswap32(540);
  if (swaps)
    size = __builtin_bswap32(size);
  if ((size != 348 && size != 540) || bytes.size() < size)
    return Error::input("it does not begin with a NIfTI header");
  const Reader reader(bytes, swaps, size == 348);
  const auto hasMagic = [&](std::string_view first, std::string_view second) {
    return reader.hasMagic(size == 348 ? first : second);
  };
  NiftiHeader header;
  header.isPair = hasMagic({"ni1\0", 4}, {"ni2\0\r\n\x1a\n", 8});
  header.isAnalyze =
      !header.isPair && !hasMagic({"n+1\0", 4}, {"n+2\0\r\n\x1a\n", 8}) && allowsAnalyze && size == 348;
  if (header.isAnalyze)
    header.isPair = true;
  else if (!header.isPair && !hasMagic({"n+1\0", 4}, {"n+2\0\r\n\x1a\n", 8}))
    return Error::input("it does not begin with a NIfTI header");
  return readFields(bytes, reader, swaps == (std::endian::native == std::endian::little), header);
}

} // namespace voxc
