// The files of report-runtime: the page's templates, style and script, compiled in as text.
#pragma once

#include <string_view>

namespace voxc::report {

/// The text of a file by its path below report-runtime; empty if there is none.
std::string_view runtimeFile(std::string_view path);

} // namespace voxc::report
