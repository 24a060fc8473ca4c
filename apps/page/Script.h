// What a page does: its script, with the shaders of its volume.
#pragma once

#include "page/Page.h"

namespace voxc::page {

/// The script of a page, which is the body of an asynchronous function of `words`, `checks` and `status`.
/// Error: that of a plan.
Expected<std::string> makeScript(const Volume &volume, const PageContents &contents);

/// What is shown while nothing is there to be seen.
inline constexpr std::string_view kWait = "Making the picture ready …";

} // namespace voxc::page
