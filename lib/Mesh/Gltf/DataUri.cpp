// Base 64, and percent signs.
#include "Mesh/Gltf/DataUri.h"

#include <array>
#include <charconv>

namespace voxc {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 255;

constexpr std::array<std::uint8_t, 256> makeValues() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  return values;
}

constexpr std::array<std::uint8_t, 256> kValues = makeValues();

/// Writes the bytes of `text`, which has no padding; false if it is not base 64.
bool decodeBase64(std::string_view text, std::byte *out) {
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kNoDigit)
      return false;
    bits = bits << 6 | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      *out++ = static_cast<std::byte>(bits >> count & 255);
    }
  }
  return true;
}

} // namespace

Expected<ScratchArray<std::byte>> decodeDataUri(std::string_view uri, std::shared_ptr<WorkingMemory> memory) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
    return Error::input("its data URI is not in base 64");
  std::string_view text = uri.substr(comma + 1);
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding)
    text.remove_suffix(1);
  ScratchArray<std::byte> bytes(std::move(memory));
  VOXC_TRY(bytes.resize(text.size() / 4 * 3 + text.size() % 4 * 3 / 4));
  if (!decodeBase64(text, bytes.data()))
    return Error::input("its data URI is not in base 64");
  return bytes;
}

std::string uriToPath(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const char *digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      path += static_cast<char>(value);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

} // namespace voxc
