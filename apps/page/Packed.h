// Bytes as characters of a page: deflate, which browsers inflate, at seven bits a character.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace voxc::page {

/// So many words lie together in `planesOf`.
inline constexpr std::size_t kBlockWords = std::size_t{1} << 16;

/// The words as bytes: of each block of `kBlockWords` the bytes of rank 0, then those of rank 1 and so on,
/// which deflate finds more in than in words.
std::string planesOf(std::span<const std::uint32_t> words);

/// Raw deflate (RFC 1951), at zlib's best.
std::string deflated(std::string_view bytes);

/// The bytes as UTF-8, eight for seven bytes: the bits from the highest of the first byte on, seven a
/// character, the last filled up with 0. HTML would change characters 0 and 13, and 60 may begin a tag:
/// there, a character of two bytes says which of the three it is and what the next seven bits are.
std::string sevenBitText(std::string_view bytes);

} // namespace voxc::page
