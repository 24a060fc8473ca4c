// Bytes as characters of a page.
#include "page/Packed.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>

namespace voxc::page {
namespace {

/// What must not stand in a page as it is.
constexpr std::array<unsigned, 3> kUnfit = {0, '\r', '<'};
constexpr unsigned kFirstPair = 0x100; ///< The character for the first of them and seven bits of 0.

class SevenBitWriter {
public:
  void put(unsigned seven) {
    if (unfit_) {
      const unsigned character = kFirstPair + *unfit_ * 128 + seven;
      text_ += static_cast<char>(0xc0 | character >> 6);
      text_ += static_cast<char>(0x80 | (character & 0x3f));
      unfit_.reset();
    } else if (const auto found = std::ranges::find(kUnfit, seven); found != kUnfit.end()) {
      unfit_ = static_cast<unsigned>(found - kUnfit.begin());
    } else {
      text_ += static_cast<char>(seven);
    }
  }

  std::string finish() {
    if (unfit_)
      put(0);
    return std::move(text_);
  }

  void reserve(std::size_t size) { text_.reserve(size); }

private:
  std::string text_;
  std::optional<unsigned> unfit_; ///< Waits for the next seven bits.
};

} // namespace

std::string planesOf(std::span<const std::uint32_t> words) {
  std::string planes;
  planes.reserve(words.size() * 4);
  for (; !words.empty(); words = words.subspan(std::min(words.size(), kBlockWords)))
    for (unsigned rank = 0; rank < 4; ++rank)
      for (const std::uint32_t word : words.first(std::min(words.size(), kBlockWords)))
        planes += static_cast<char>(word >> 8 * rank);
  return planes;
}

std::string deflated(std::string_view bytes) {
  z_stream stream{};
  constexpr int kRaw = -15, kMostMemory = 9;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRaw, kMostMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string result;
  std::array<char, 1 << 16> piece;
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30; // zlib counts in 32 bits.
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      const std::string_view next = bytes.substr(0, kMostAtOnce);
      stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(next.data()));
      stream.avail_in = static_cast<uInt>(next.size());
      bytes.remove_prefix(next.size());
    }
    stream.next_out = reinterpret_cast<Bytef *>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return result;
}

std::string sevenBitText(std::string_view bytes) {
  SevenBitWriter writer;
  writer.reserve(bytes.size() / 7 * 8 + 8);
  unsigned held = 0;
  int bits = 0;
  for (const char byte : bytes) {
    held = held << 8 | static_cast<unsigned char>(byte);
    for (bits += 8; bits >= 7; bits -= 7)
      writer.put(held >> (bits - 7) & 127);
  }
  if (bits > 0)
    writer.put(held << (7 - bits) & 127);
  return writer.finish();
}

} // namespace voxc::page
