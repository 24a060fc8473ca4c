// Fuzzes .hvx files of all versions, with right checksums.
#include "RightChecksums.h"
#include "VolumeUse.h"
#include "WordMutator.h"

#include "Volume/VolumeFile.h"

namespace {

/// Every byte of every stream must be there.
void touch(const voxc::Volume &volume) {
  static volatile std::uint8_t sink = 0;
  for (const voxc::Stream &stream : volume.streams())
    for (const std::byte byte : stream.bytes)
      sink = sink ^ std::to_integer<std::uint8_t>(byte);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = voxc::fuzz::withRightChecksums(data, size);
  if (const auto volume = voxc::readVolumeFile(bytes, nullptr, "a.hvx")) {
    touch(*volume);
    voxc::fuzz::decodeAll(*volume);
  }
  return 0;
}
