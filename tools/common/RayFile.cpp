// Ray files and hit files, of both versions.
#include "RayFile.h"

#include "voxc/Trace/Face.h"

#include <cstring>
#include <string_view>

namespace voxc::tool {
namespace {

constexpr std::string_view kRayMagic = "VOXCRAYS", kHitMagic = "VOXCHITS";
constexpr std::uint32_t kVersion = 2;

/// What stands before the records of version 2; little-endian, as all that follows.
struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t recordBytes;
  std::uint64_t records;
};

static_assert(sizeof(Header) == 24);

Header headerOf(std::string_view magic, std::size_t recordBytes, std::size_t records) {
  Header header{{}, kVersion, static_cast<std::uint32_t>(recordBytes), records};
  magic.copy(header.magic, sizeof header.magic);
  return header;
}

/// A whole number of records, one behind another.
template <typename Record> std::vector<Record> recordsOf(std::span<const std::byte> bytes) {
  std::vector<Record> records(bytes.size() / sizeof(Record));
  if (!records.empty())
    std::memcpy(records.data(), bytes.data(), records.size() * sizeof(Record));
  return records;
}

template <typename Bytes> void append(std::string &text, const Bytes &bytes) {
  text.append(reinterpret_cast<const char *>(&bytes), sizeof bytes);
}

bool beginsWith(std::span<const std::byte> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

Expected<RayFile> parseVersion2(std::span<const std::byte> bytes, const std::string &name) {
  Header header;
  if (bytes.size() < sizeof header)
    return Error::input(name + " ends within its header of " + std::to_string(sizeof header) + " bytes");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.version != kVersion)
    return Error::input(name + " is a ray file of version " + std::to_string(header.version) +
                        ", but this voxc reads versions 1 and 2");
  if (header.recordBytes != sizeof(BoundedRay))
    return Error::input(name + " has rays of " + std::to_string(header.recordBytes) +
                        " bytes each; those of version 2 have 32");
  const std::span<const std::byte> records = bytes.subspan(sizeof header);
  if (records.size() % sizeof(BoundedRay) != 0 || records.size() / sizeof(BoundedRay) != header.records)
    return Error::input(name + " should have " + std::to_string(header.records) +
                        " rays of 32 bytes behind its header, but has " + std::to_string(records.size()) +
                        " bytes there");
  return RayFile(recordsOf<BoundedRay>(records));
}

} // namespace

Expected<RayFile> parseRayFile(std::span<const std::byte> bytes, const std::string &name) {
  if (beginsWith(bytes, kRayMagic))
    return parseVersion2(bytes, name);
  if (beginsWith(bytes, kHitMagic))
    return Error::input(name + " is a hit file, but a ray file is wanted");
  if (bytes.size() % sizeof(Ray) != 0)
    return Error::input(name + " has " + std::to_string(bytes.size()) +
                        " bytes, but rays are 6 float32 each: it should have a multiple of 24");
  return RayFile(recordsOf<Ray>(bytes));
}

std::string rayFileText(std::span<const BoundedRay> rays) {
  std::string text;
  append(text, headerOf(kRayMagic, sizeof(BoundedRay), rays.size()));
  return text.append(reinterpret_cast<const char *>(rays.data()), rays.size_bytes());
}

std::string hitFileText(std::span<const Hit> hits, std::span<const std::uint32_t> steps) {
  std::string text;
  text.reserve(sizeof(Header) + hits.size() * sizeof(HitRecord));
  append(text, headerOf(kHitMagic, sizeof(HitRecord), hits.size()));
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit &hit = hits[i];
    const glm::vec3 normal = hit.isHit() ? normalOf(hit.steps) : glm::vec3(0);
    append(text, HitRecord{{hit.voxel[0], hit.voxel[1], hit.voxel[2]},
                           hit.rgba,
                           hit.t,
                           hit.isHit() ? hit.steps : 0,
                           {normal.x, normal.y, normal.z},
                           steps.empty() ? 0 : steps[i]});
  }
  return text;
}

} // namespace voxc::tool
