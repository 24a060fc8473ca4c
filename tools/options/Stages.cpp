// Stages, from the figures that a run has left.
#include "options/Stages.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace voxc::tool {
namespace {

double sumOf(const Json &figures, std::initializer_list<const char *> keys) {
  double seconds = 0;
  for (const char *key : keys)
    seconds += figures.value(key, 0.0);
  return seconds;
}

struct Stage {
  const char *name;
  double (*seconds)(const Json &figures);
};

/// In the order in which they are.
constexpr Stage kStages[] = {
    {"device", [](const Json &f) { return sumOf(f, {"open_seconds"}); }},
    {"format", [](const Json &f) { return sumOf(f, {"choose_seconds"}); }},
    {"input",
     [](const Json &f) {
       return sumOf(f, {f.contains("input_seconds") ? "input_seconds" : "load_seconds"});
     }},
    {"code", [](const Json &f) { return sumOf(f, {"compile_seconds"}); }},
    {"build", [](const Json &f) { return sumOf(f, {"build_seconds"}); }},
    {"kernel", [](const Json &f) { return sumOf(f, {"kernel_seconds", "upload_seconds"}); }},
    {"camera", [](const Json &f) { return sumOf(f, {"camera_seconds"}); }},
    {"rays",
     [](const Json &f) {
       return f.contains("picture_seconds") ? sumOf(f, {"seconds", "light_seconds"}) : 0;
     }},
    {"shading",
     [](const Json &f) {
       return std::max(sumOf(f, {"picture_seconds"}) - sumOf(f, {"seconds", "light_seconds"}), 0.0);
     }},
    {"check", [](const Json &f) { return sumOf(f, {"check_seconds"}); }},
    {"writing", [](const Json &f) { return sumOf(f, {"file_seconds"}); }},
};

/// Hundredths, as they are printed: of these the parts add up.
long hundredths(double seconds) { return std::lround(100 * seconds); }

std::string printed(long hundredths) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", double(hundredths) / 100);
  return text;
}

} // namespace

void addStages(Json &figures, double totalSeconds) {
  Json stages = Json::object();
  double left = totalSeconds;
  for (const Stage &stage : kStages)
    if (const double seconds = stage.seconds(figures); seconds > 0) {
      stages[stage.name] = seconds;
      left -= seconds;
    }
  stages["rest"] = std::max(left, 0.0);
  figures["total_seconds"] = totalSeconds;
  figures["stages"] = std::move(stages);
}

std::string stagesText(const Json &figures) {
  if (!figures.contains("stages"))
    return {};
  // A part is what is printed of all up to its end, less what was printed before: so no rounding is left
  // over.
  double end = 0;
  long before = 0;
  std::string parts;
  for (const Stage &stage : kStages) {
    end += figures["stages"].value(stage.name, 0.0);
    if (const long part = hundredths(end) - before; part > 0)
      parts += std::string(stage.name) + " " + printed(part) + ", ";
    before = hundredths(end);
  }
  const long total = hundredths(figures["total_seconds"]);
  return printed(total) + " s: " + parts + "rest " + printed(std::max(total - before, 0L));
}

} // namespace voxc::tool
