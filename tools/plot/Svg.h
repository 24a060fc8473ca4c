// Writing SVG elements.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace voxc::plot {

/// Text with what XML reserves escaped.
std::string escaped(std::string_view text);

/// A place as SVG writes it: at most one digit after the point.
std::string coordinate(double value);

using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

/// <name attributes>content</name>, or <name attributes/> without content. The content is not escaped.
std::string element(std::string_view name, Attributes attributes, std::string_view content = {});

} // namespace voxc::plot
