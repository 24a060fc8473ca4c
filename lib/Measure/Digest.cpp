// FNV-1a.
#include "voxc/Measure/Digest.h"

#include "voxc/Support/File.h"

#include <cstdio>

namespace voxc::measure {

void Digest::addBytes(std::string_view bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (const char byte : bytes)
    state_ = (state_ ^ static_cast<unsigned char>(byte)) * kPrime;
}

Digest &Digest::add(std::string_view part) {
  const std::uint64_t size = part.size();
  addBytes({reinterpret_cast<const char *>(&size), sizeof size});
  addBytes(part);
  return *this;
}

Expected<void> Digest::addFile(const std::string &path) {
  const auto file = VOXC_TRY(MappedFile::open(path));
  add({reinterpret_cast<const char *>(file.bytes().data()), file.bytes().size()});
  return {};
}

std::string Digest::hex() const {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_));
  return digits;
}

} // namespace voxc::measure
