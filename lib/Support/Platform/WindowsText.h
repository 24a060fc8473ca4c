// Text as Windows wants it.
#pragma once

#include <string>
#include <string_view>

namespace voxc::platform {

/// UTF-8 as UTF-16. What is no UTF-8 becomes a replacement character.
std::wstring wide(std::string_view utf8);
std::string narrow(std::wstring_view utf16);

} // namespace voxc::platform
