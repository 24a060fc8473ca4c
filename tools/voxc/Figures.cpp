// Figures as aligned lines and as JSON.
#include "Figures.h"

#include "common/Statistics.h"

#include <cstdio>

namespace voxc::tool {

namespace {

std::string plainText(const Json &value) {
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_array()) {
    std::string text;
    for (const Json &element : value)
      text += (text.empty() ? "" : ", ") + plainText(element);
    return text;
  }
  if (!value.is_number_float())
    return value.dump();
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value.get<double>());
  return text;
}

void printLines(const Json &figures, const std::string &prefix) {
  for (const auto &[key, value] : figures.items()) {
    if (value.is_object())
      printLines(value, prefix + key + ".");
    else
      std::fprintf(stderr, "  %-24s %s\n", (prefix + key).c_str(), plainText(value).c_str());
  }
}

} // namespace

Expected<void> tellFigures(const CommonOptions &common, const Json &figures) {
  if (!common.quiet)
    printLines(figures, "");
  return writeStatistics(common.stats, figures);
}

bool tellsOnStdout(const CommonOptions &common) { return !common.quiet && common.stats != "-"; }

} // namespace voxc::tool
