// HTML as text: elements, templates, and figures as people read them.
#pragma once

#include "plot/Svg.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace voxc::report {

using plot::escaped;

/// <name attributes>content</name>, closed even if it is empty, as HTML wants it. The content is not escaped.
std::string tag(std::string_view name, plot::Attributes attributes, std::string_view content);
/// The same around text, which is escaped.
std::string textTag(std::string_view name, plot::Attributes attributes, std::string_view text);

using Values = std::map<std::string, std::string, std::less<>>;

/// A file of report-runtime with every {{name}} replaced by its value, which is not looked into again. Empty
/// if there is no such file, and where there is no such value.
std::string fill(std::string_view path, const Values &values);

/// Three digits that count, without exponents: "0.0312", "4.74", "1230".
std::string numberText(double value);
/// A whole number in groups of three: "1,440,000".
std::string countText(double value);
/// "12.3 MiB".
std::string bytesText(double bytes);
/// A share: "2.3 %".
std::string percentText(double share);
/// "1 format", "20 formats".
std::string plural(std::size_t count, std::string_view noun);

} // namespace voxc::report
