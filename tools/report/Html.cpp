// HTML as text.
#include "report/Html.h"

#include "report/RuntimeFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace voxc::report {
namespace {

std::string fixed(double value, int digits) {
  char text[400]; // The largest double has 309 digits.
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

} // namespace

std::string tag(std::string_view name, plot::Attributes attributes, std::string_view content) {
  std::string text = "<" + std::string(name);
  for (const auto &[key, value] : attributes)
    text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  return text + ">" + std::string(content) + "</" + std::string(name) + ">";
}

std::string textTag(std::string_view name, plot::Attributes attributes, std::string_view text) {
  return tag(name, attributes, escaped(text));
}

std::string fill(std::string_view path, const Values &values) {
  std::string_view rest = runtimeFile(path);
  std::string result;
  for (;;) {
    const std::size_t begin = rest.find("{{"), end = rest.find("}}", begin);
    result += rest.substr(0, begin);
    if (end == std::string_view::npos)
      return result;
    if (const auto value = values.find(rest.substr(begin + 2, end - begin - 2)); value != values.end())
      result += value->second;
    rest.remove_prefix(end + 2);
  }
}

std::string numberText(double value) {
  if (value == 0)
    return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fixed(value, std::clamp(2 - magnitude, 0, 9));
}

std::string countText(double value) {
  std::string text = fixed(value, 0);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, ",");
  return text;
}

std::string bytesText(double bytes) {
  static constexpr const char *kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= 1024 && unit + 1 < std::size(kUnits); ++unit)
    bytes /= 1024;
  return numberText(bytes) + " " + kUnits[unit];
}

std::string percentText(double share) { return fixed(100 * share, 1) + " %"; }

std::string plural(std::size_t count, std::string_view noun) {
  return countText(static_cast<double>(count)) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

} // namespace voxc::report
