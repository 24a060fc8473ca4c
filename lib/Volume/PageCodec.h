// One page of a stream and what a file stores of it (docs/hvx.md): its elements byte by byte, compressed by
// zstd.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace voxc {

/// Compresses pages, one after the other.
class PageEncoder {
public:
  /// Bytes that an encoder takes, about.
  static constexpr std::uint64_t kBytes = std::uint64_t{4} << 20;

  PageEncoder();

  /// What to store of a page: fewer bytes, or the page itself. It lives until the next call, and as the page
  /// does.
  std::span<const std::byte> encode(std::span<const std::byte> page, std::uint32_t elementBytes);

private:
  struct Free {
    void operator()(ZSTD_CCtx_s *context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
  std::vector<std::byte> planes_;
  std::vector<std::byte> stored_;
};

/// Decodes pages, one after the other.
class PageDecoder {
public:
  PageDecoder();

  /// Fills `page`, of at least one byte. False if that is not exactly what is stored; nothing is written
  /// beyond it then either.
  bool decode(std::span<const std::byte> stored, std::uint32_t elementBytes, std::span<std::byte> page);

private:
  struct Free {
    void operator()(ZSTD_DCtx_s *context) const;
  };
  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
  std::vector<std::byte> planes_;
};

} // namespace voxc
