// The head of LAS files, whose numbers are little-endian.
#include "Input/Las/LasFile.h"

#include "Input/Las/LasNumbers.h"

#include <cmath>
#include <string>

namespace voxc {

namespace {

/// Bytes of the fields of each format of points.
constexpr std::array<std::uint64_t, 11> kFormatBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

// Where fields of the head lie.
constexpr std::size_t kMajor = 24, kMinor = 25, kHeaderBytes = 94, kPoints = 96, kRecords = 100,
                      kFormat = 104, kStride = 105, kOldCount = 107, kScale = 131, kOffset = 155,
                      kLateRecords = 243, kCount = 247;
constexpr std::size_t kOldBytes = 227, kNewBytes = 375;

} // namespace

Expected<LasHeader> readLasHeader(std::span<const std::byte> bytes) {
  if (bytes.size() < kOldBytes || lasNumber<std::uint32_t>(bytes, 0) != 0x4653414c)
    return Error::input("it does not begin with the head of a LAS file");
  LasHeader header;
  header.minor = std::to_integer<int>(bytes[kMinor]);
  if (std::to_integer<int>(bytes[kMajor]) != 1 || header.minor > 4)
    return Error::input("it is of version " + std::to_string(std::to_integer<int>(bytes[kMajor])) + "." +
                        std::to_string(header.minor) + "; voxc reads 1.0 to 1.4");
  if (lasNumber<std::uint16_t>(bytes, kHeaderBytes) > bytes.size())
    return Error::input("it ends within its head");
  const unsigned format = std::to_integer<unsigned>(bytes[kFormat]);
  if ((format & 0xc0) != 0)
    return Error::input("its points are compressed by LASzip, which voxc does not read; save it as an "
                        "uncompressed .las or as .ply, for example by CloudCompare or 'las2las'");
  header.format = format;
  header.stride = lasNumber<std::uint16_t>(bytes, kStride);
  if (format >= kFormatBytes.size() || header.stride < kFormatBytes[format])
    return Error::input("its points are of the format " + std::to_string(format) + " and have " +
                        std::to_string(header.stride) +
                        " bytes; voxc reads the formats 0 to 10, as long as they are");
  const bool isNew = header.minor == 4 && bytes.size() >= kNewBytes &&
                     lasNumber<std::uint16_t>(bytes, kHeaderBytes) >= kNewBytes;
  header.count = isNew ? lasNumber<std::uint64_t>(bytes, kCount) : 0;
  if (header.count == 0)
    header.count = lasNumber<std::uint32_t>(bytes, kOldCount);
  header.records = std::uint64_t{lasNumber<std::uint32_t>(bytes, kRecords)} +
                   (isNew ? lasNumber<std::uint32_t>(bytes, kLateRecords) : 0);
  const std::uint64_t begin = lasNumber<std::uint32_t>(bytes, kPoints);
  const std::uint64_t room = begin < bytes.size() ? bytes.size() - begin : 0;
  if (header.count > room / header.stride)
    return Error::input("it has " + std::to_string(header.count) + " points by its head, but only " +
                        std::to_string(room / header.stride) + " are there");
  // Records may stand behind the points, and waveforms.
  constexpr std::uint32_t kWaves = 1u << 4 | 1u << 5 | 1u << 9 | 1u << 10;
  const bool mayHaveMore =
      (isNew && lasNumber<std::uint32_t>(bytes, kLateRecords) > 0) || (kWaves >> format & 1) != 0;
  header.behind = mayHaveMore ? 0 : room - header.count * header.stride;
  if (header.count > 0)
    header.points = bytes.subspan(begin, header.count * header.stride);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = lasNumber<double>(bytes, kScale + 8 * axis);
    header.offset[axis] = lasNumber<double>(bytes, kOffset + 8 * axis);
    if (!std::isfinite(header.scale[axis]) || header.scale[axis] == 0 || !std::isfinite(header.offset[axis]))
      return Error::input("its scale is 0 or no number, or its offset is none");
  }
  return header;
}

} // namespace voxc
