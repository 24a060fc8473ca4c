// What texts around kernels call a format before it is known: files of shaders-runtime/header speak of
// voxc_format_closest, of FORMAT and its DIGEST, and are valid text of their language as they stand.
#pragma once

#include "voxc/Layout/Layout.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace voxc {

/// Words, and what takes their place. One that ends in "_" stands for the begin of words as well.
using FormatWords = std::map<std::string, std::string, std::less<>>;

/// FORMAT, its DIGEST, and the halves of this, DIGEST_LOW and DIGEST_HIGH, since GLSL has no number of 64
/// bits.
FormatWords formatWords(const Layout &layout);

/// 0x and 16 digits.
std::string hexadecimal(std::uint64_t number);

/// The text with other words in place of these, in comments too. A word is of letters, digits and "_".
std::string replaceWords(std::string_view text, const FormatWords &words);

} // namespace voxc
