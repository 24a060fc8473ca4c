// Bytes of MagicaVoxel files: chunks of four letters, the size of their content, and that of their children.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace voxc {

/// The content of a chunk: little-endian words and strings.
class VoxBytes {
public:
  VoxBytes &word(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
      text_.push_back(static_cast<char>(value >> shift & 255));
    return *this;
  }
  VoxBytes &text(std::string_view value) {
    text_ += value;
    return *this;
  }
  VoxBytes &string(std::string_view value) {
    return word(static_cast<std::uint32_t>(value.size())).text(value);
  }
  VoxBytes &chunk(std::string_view name, const VoxBytes &content) {
    return text(name).word(static_cast<std::uint32_t>(content.text_.size())).word(0).text(content.text_);
  }
  const std::string &text() const { return text_; }

private:
  std::string text_;
};

} // namespace voxc
