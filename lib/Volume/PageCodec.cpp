// Pages as bytes of equal rank one behind the other, and zstd.
#include "PageCodec.h"

#include <zstd.h>

#include <algorithm>
#include <new>

namespace voxc {
namespace {

// Level 9 stores 2 to 8 % less than level 3 does, at 50 to 80 MB/s and core, and is decoded as fast. Level 19
// stores another 2 to 16 % less, at a tenth of the speed (docs/hvx.md).
constexpr int kCompressionLevel = 9;

constexpr std::size_t kWordBytes = 4;

// Words of a volume are offsets, masks and colours: bytes of equal rank are more like each other than
// neighbours are, so that zstd finds more in planes of them, and finds it faster.

/// The bytes of rank 0 of all whole elements, then those of rank 1 and so on, then what is left of the page.
/// `Bytes`: of an element, where the compiler knows; 0 where it does not.
template <std::size_t Bytes>
void toPlanes(std::span<const std::byte> page, std::size_t told, std::byte *planes) {
  const std::size_t elementBytes = Bytes ? Bytes : told;
  const std::size_t elements = page.size() / elementBytes;
  for (std::size_t i = 0; i < elements; ++i)
    for (std::size_t rank = 0; rank < elementBytes; ++rank)
      planes[rank * elements + i] = page[i * elementBytes + rank];
  const std::size_t whole = elements * elementBytes;
  std::ranges::copy(page.subspan(whole), planes + whole);
}

template <std::size_t Bytes>
void fromPlanes(const std::byte *planes, std::size_t told, std::span<std::byte> page) {
  const std::size_t elementBytes = Bytes ? Bytes : told;
  const std::size_t elements = page.size() / elementBytes;
  for (std::size_t i = 0; i < elements; ++i)
    for (std::size_t rank = 0; rank < elementBytes; ++rank)
      page[i * elementBytes + rank] = planes[rank * elements + i];
  const std::size_t whole = elements * elementBytes;
  std::copy_n(planes + whole, page.size() - whole, page.begin() + static_cast<std::ptrdiff_t>(whole));
}

/// True if the bytes are one frame, and it says itself that it holds so many: nothing else has a single
/// meaning.
bool isOneFrame(std::span<const std::byte> stored, std::size_t bytes) {
  return ZSTD_getFrameContentSize(stored.data(), stored.size()) == bytes &&
         ZSTD_findFrameCompressedSize(stored.data(), stored.size()) == stored.size();
}

template <typename Context> Context *given(Context *context) {
  if (!context)
    throw std::bad_alloc();
  return context;
}

} // namespace

PageEncoder::PageEncoder() : context_(given(ZSTD_createCCtx())) {
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, kCompressionLevel);
}

void PageEncoder::Free::operator()(ZSTD_CCtx_s *context) const { ZSTD_freeCCtx(context); }

std::span<const std::byte> PageEncoder::encode(std::span<const std::byte> page, std::uint32_t elementBytes) {
  planes_.resize(page.size());
  stored_.resize(page.size());
  const auto split = elementBytes == kWordBytes ? toPlanes<kWordBytes> : toPlanes<0>;
  split(page, elementBytes, planes_.data());
  // What has no room in as many bytes is an error, and stored as it is.
  const std::size_t bytes =
      ZSTD_compress2(context_.get(), stored_.data(), stored_.size(), planes_.data(), planes_.size());
  return ZSTD_isError(bytes) || bytes >= page.size() ? page : std::span(stored_).first(bytes);
}

PageDecoder::PageDecoder() : context_(given(ZSTD_createDCtx())) {}

void PageDecoder::Free::operator()(ZSTD_DCtx_s *context) const { ZSTD_freeDCtx(context); }

bool PageDecoder::decode(std::span<const std::byte> stored, std::uint32_t elementBytes,
                         std::span<std::byte> page) {
  if (stored.size() == page.size()) {
    std::ranges::copy(stored, page.begin());
    return true;
  }
  planes_.resize(page.size());
  if (!isOneFrame(stored, page.size()) || ZSTD_decompressDCtx(context_.get(), planes_.data(), planes_.size(),
                                                              stored.data(), stored.size()) != page.size())
    return false;
  const auto join = elementBytes == kWordBytes ? fromPlanes<kWordBytes> : fromPlanes<0>;
  join(planes_.data(), elementBytes, page);
  return true;
}

} // namespace voxc
