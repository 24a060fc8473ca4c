// Fuzzes .hvx files of all versions: the checksum is put right, as a hostile file's would be.
#include "FuzzedFile.h"
#include "VolumeUse.h"

#include "Volume/Checksum.h"
#include "Volume/VolumeFile.h"

#include <cstring>
#include <span>
#include <vector>

namespace {

using namespace voxc;

constexpr std::size_t kChecksumAt = 16;
constexpr std::size_t kAfter = kChecksumAt + sizeof(std::uint64_t);

void putChecksumRight(std::span<std::byte> bytes) {
  if (bytes.size() < kAfter)
    return;
  Checksum checksum;
  checksum.add(bytes.data(), kChecksumAt);
  checksum.add(bytes.data() + kAfter, bytes.size() - kAfter);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + kChecksumAt, &digest, sizeof digest);
}

/// Every byte of every stream must be there.
void touch(const Volume &volume) {
  static volatile std::uint8_t sink = 0;
  for (const Stream &stream : volume.streams())
    for (const std::byte byte : stream.bytes)
      sink = sink ^ std::to_integer<std::uint8_t>(byte);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto *begin = reinterpret_cast<const std::byte *>(data);
  std::vector<std::byte> bytes(begin, begin + size);
  putChecksumRight(bytes);
  if (const auto volume = readVolumeFile(bytes, nullptr, "a.hvx")) {
    touch(*volume);
    fuzz::decodeAll(*volume);
  }
  return 0;
}
