// Figures of a run, as a few lines for people and as JSON.
#include "options/Figures.h"

#include "options/Stages.h"

#include "common/FiguresFile.h"
#include "common/Statistics.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace voxc::tool {

namespace {

[[gnu::format(printf, 1, 2)]] std::string textOf(const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

double number(const Json &figures, const char *key) { return figures.value(key, 0.0); }

/// "12", "3,456" and "1.2 million".
std::string countText(double count) {
  if (count < 1000)
    return textOf("%.0f", count);
  if (count < 1e6)
    return textOf("%d,%03d", int(count) / 1000, int(count) % 1000);
  return textOf("%.1f million", count / 1e6);
}

std::string bytesText(double bytes) {
  constexpr const char *kUnits[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  int unit = 0;
  for (; bytes >= 1024 && unit < 4; ++unit)
    bytes /= 1024;
  return textOf(unit == 0 ? "%.0f %s" : "%.2f %s", bytes, kUnits[unit]);
}

std::string secondsText(double seconds) {
  return seconds < 100 ? textOf("%.2f s", seconds) : textOf("%.0f s", seconds);
}

/// "3.7 million rays in 0.43 s, 8.61 million a second".
std::string speedText(const char *what, double rays, double seconds) {
  std::string text = countText(rays) + " " + what + " in " + secondsText(seconds);
  return seconds > 0 ? text + textOf(", %.3g million a second", rays / seconds * 1e-6) : text;
}

std::string readText(const Json &figures) {
  if (!figures.contains("input"))
    return {};
  std::string text = figures["input"].get<std::string>();
  if (number(figures, "triangles") > 0)
    text += ": " + countText(number(figures, "triangles")) + " triangles";
  return text + ", in " + secondsText(number(figures, "load_seconds") + number(figures, "bin_seconds"));
}

std::string builtText(const Json &figures) {
  if (!figures.contains("build_seconds"))
    return {};
  return "in " + secondsText(number(figures, "build_seconds"));
}

std::string exportedText(const Json &figures) {
  if (!figures.contains("export_seconds") || !figures.contains("file_bytes"))
    return {};
  return bytesText(number(figures, "file_bytes")) + ", in " + secondsText(number(figures, "export_seconds"));
}

std::string volumeText(const Json &figures) {
  if (!figures.contains("extent") || !figures.contains("bytes"))
    return {};
  const Json &extent = figures["extent"];
  const double voxels = number(figures, "voxels"), bytes = number(figures, "bytes");
  std::string text = figures.value("format", "") + textOf(", %d x %d x %d, ", extent[0].get<int>(),
                                                          extent[1].get<int>(), extent[2].get<int>());
  text += countText(voxels) + " voxels, " + bytesText(bytes);
  return voxels > 0 ? text + textOf(", %.3g bytes a voxel", bytes / voxels) : text;
}

std::string tracedText(const Json &figures) {
  if (!figures.contains("rays"))
    return {};
  std::string text = speedText("rays", number(figures, "rays"), number(figures, "seconds"));
  if (figures.contains("light_rays"))
    text += "; " + speedText("to the light", number(figures, "light_rays"), number(figures, "light_seconds"));
  return text + "; on " + figures.value("device", "");
}

std::string errorText(const Json &figures) {
  if (!figures.contains("error"))
    return {};
  const Json &error = figures["error"];
  const double differ =
      number(error, "missed") + number(error, "ghost") + number(error, "wrong") + number(error, "colour");
  return countText(number(error, "rays")) + " rays against the exact oracle: " +
         (differ == 0 ? "all hits right" : countText(differ) + " differ") +
         textOf(", t off by %.3g voxels at most", number(error, "max_dt"));
}

/// A budget in which no page would have been read twice, if some were.
std::string enoughText(const Json &figures) {
  const double used = number(figures, "pages_used");
  if (number(figures, "pages_read") <= used)
    return {};
  constexpr double kKiB = 1024, kMiB = 1024 * kKiB;
  const double bytes = number(figures, "enough_bytes");
  const std::string size =
      bytes < kMiB ? textOf("%.0fKiB", std::ceil(bytes / kKiB)) : textOf("%.0fMiB", std::ceil(bytes / kMiB));
  return "; the " + countText(used) + " different ones have room in --device-memory " + size;
}

std::string pagedText(const Json &figures) {
  if (!figures.contains("pages_read"))
    return {};
  return countText(number(figures, "pages_read")) + " pages read, " +
         countText(number(figures, "page_hits")) + " found" +
         textOf(", a hit rate of %.2f %%; in ", 100 * number(figures, "page_hit_rate")) +
         bytesText(number(figures, "paging_bytes")) + enoughText(figures);
}

std::string coarseText(const Json &figures) {
  if (!figures.contains("coarse_share"))
    return {};
  return textOf("%.2f %% of the eye's rays", 100 * number(figures, "coarse_share")) +
         (figures.contains("light_coarse_share")
              ? textOf(" and %.2f %% of those to the light", 100 * number(figures, "light_coarse_share"))
              : "") +
         " met a coarse block; " + countText(number(figures, "coarse_blocks")) + " blocks in " +
         bytesText(number(figures, "coarse_bytes"));
}

/// Frames in one volume, and what they share with each other.
std::string animationText(const Json &figures) {
  if (!figures.contains("animation"))
    return {};
  const Json &frames = figures["animation"];
  double added = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    added += number(frames[i], "words");
  const double first = number(frames[0], "words");
  return countText(double(frames.size())) + ", of " + countText(first) + " words and " +
         countText(added / double(frames.size() - 1)) + " more for each frame after the first";
}

std::string flightText(const Json &figures) {
  if (!figures.contains("frames"))
    return {};
  return countText(double(figures["frames"].size())) + " frames in " +
         secondsText(number(figures, "render_seconds"));
}

std::string cameraText(const Json &figures) { return figures.value("camera", ""); }

/// Of a view that nobody asked for.
std::string viewText(const Json &figures) {
  if (!figures.value("view_is_auto", false))
    return {};
  const std::string view = figures.value("view", "");
  return view == "inside" ? "inside; --view iso looks from outside" : view + ", from outside";
}

struct Line {
  const char *label;
  std::string (*text)(const Json &figures); ///< Empty: the line is left out.
};

constexpr Line kLines[] = {
    {"read", readText},        {"volume", volumeText}, {"built", builtText},   {"traced", tracedText},
    {"paged", pagedText},      {"coarse", coarseText}, {"checked", errorText}, {"flight", flightText},
    {"frames", animationText}, {"view", viewText},     {"camera", cameraText}, {"file", exportedText},
};

void printLine(const std::string &label, const std::string &text) {
  std::fprintf(stderr, "  %-8s %s\n", label.c_str(), text.c_str());
}

/// Names of files that were written; of many the first and the last.
void printFiles(const Json &files) {
  constexpr std::size_t kMost = 3;
  if (files.size() > kMost) {
    printLine("wrote", files.front().get<std::string>() + " to " + files.back().get<std::string>() + ", " +
                           std::to_string(files.size()) + " files");
    return;
  }
  for (const Json &file : files)
    if (file != "-")
      printLine("wrote", file.get<std::string>());
}

} // namespace

void addWritten(Json &figures, const std::string &path) { figures["files"].push_back(path); }

Expected<void> tellFigures(const CommonOptions &common, const Json &figures) {
  if (!common.quiet) {
    for (const Line &line : kLines)
      if (const std::string text = line.text(figures); !text.empty())
        printLine(line.label, text);
    printFiles(figures.value("files", Json::array()));
    if (const std::string text = stagesText(figures); !text.empty())
      printLine("took", text);
  }
  for (const Json &file : figures.value("files", Json::array()))
    VOXC_TRY(checkFiguresApart(common.stats, file.get<std::string>()));
  return writeStatistics(common.stats, figures);
}

bool tellsOnStdout(const CommonOptions &common) { return common.stats != "-"; }

} // namespace voxc::tool
