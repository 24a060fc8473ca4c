// XXH3 behind a small interface.
#include "cluster/TextDigest.h"

#include "voxc/Support/File.h"

#include <array>
#include <cstdint>
#include <cstdio>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc::tool::cluster {

struct TextDigest::State {
  XXH3_state_t hash;
};

TextDigest::TextDigest() : state_(std::make_unique<State>()) { XXH3_64bits_reset(&state_->hash); }
TextDigest::~TextDigest() = default;

TextDigest &TextDigest::add(std::string_view part) {
  const std::uint64_t size = part.size();
  XXH3_64bits_update(&state_->hash, &size, sizeof size);
  XXH3_64bits_update(&state_->hash, part.data(), part.size());
  return *this;
}

Expected<void> TextDigest::addFile(const std::string &path) {
  const auto file = VOXC_TRY(MappedFile::open(path));
  const auto bytes = file.bytes();
  add({reinterpret_cast<const char *>(bytes.data()), bytes.size()});
  return {};
}

std::string TextDigest::hex() const {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx",
                static_cast<unsigned long long>(XXH3_64bits_digest(&state_->hash)));
  return text.data();
}

} // namespace voxc::tool::cluster
