// SVG as text.
#include "plot/Svg.h"

#include <cstdio>

namespace voxc::plot {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  std::string_view shortened = text;
  if (shortened.ends_with(".0"))
    shortened.remove_suffix(2);
  return std::string(shortened);
}

std::string element(std::string_view name, Attributes attributes, std::string_view content) {
  std::string text = "<" + std::string(name);
  for (const auto &[key, value] : attributes)
    text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  if (content.empty())
    return text + "/>\n";
  return text + ">" + std::string(content) + "</" + std::string(name) + ">\n";
}

} // namespace voxc::plot
