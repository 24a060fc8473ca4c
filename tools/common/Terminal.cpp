// The progress bar.
#include "Terminal.h"

#include "Help.h"
#include "Interrupt.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace voxc::tool {
namespace {

constexpr int kBarCells = 30;
constexpr int kUsualColumns = 80;
constexpr std::chrono::milliseconds kRedraw{100};
constexpr const char *kEraseLine = "\r\x1b[K";

/// What the stages count that are told at a rate.
constexpr std::pair<std::string_view, std::string_view> kCounted[] = {
    {"build", "voxels"}, {"trace", "rays"}, {"exact hits", "rays"}, {"hard rays", "rays"}};

std::string_view countedIn(std::string_view stage) {
  const auto row = std::ranges::find(kCounted, stage, &std::pair<std::string_view, std::string_view>::first);
  return row == std::end(kCounted) ? std::string_view() : row->second;
}

} // namespace

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() { clear(); }

Progress ProgressBar::progress() {
  Progress progress;
  progress.stop = &catchInterrupts();
  if (visible_)
    progress.report = [this](std::string_view stage, double fraction, std::uint64_t done) {
      draw(stage, fraction, done);
    };
  return progress;
}

void ProgressBar::clear() {
  if (drawn_)
    std::fputs(kEraseLine, stderr);
  drawn_ = false;
}

void ProgressBar::draw(std::string_view stage, double fraction, std::uint64_t done) {
  Clock::time_point now = Clock::now();
  if (drawn_ && stage == stage_ && now - lastDraw_ < kRedraw)
    return;
  if (stage != stage_)
    stageBegin_ = now;
  stage_ = stage;
  lastDraw_ = now;
  drawn_ = true;
  double shown = std::clamp(fraction, 0.0, 1.0);
  int filled = static_cast<int>(shown * kBarCells);
  std::string bar = std::string(std::size_t(filled), '#') + std::string(std::size_t(kBarCells - filled), '.');
  double seconds = std::chrono::duration<double>(now - stageBegin_).count();
  char text[160];
  std::snprintf(text, sizeof text, "%-12s [%s] %3d%%%s", stage_.c_str(), bar.c_str(),
                static_cast<int>(shown * 100), paceText(seconds, shown, done, countedIn(stage)).c_str());
  // A line that wraps could not be erased.
  std::fprintf(stderr, "%s%.*s", kEraseLine, std::max(terminalColumns(STDERR_FILENO, kUsualColumns) - 1, 1),
               text);
}

std::string paceText(double seconds, double fraction, std::uint64_t done, std::string_view counted) {
  // Before half a second or a hundredth of the way any number would be a guess.
  if (seconds < 0.5)
    return {};
  char text[64];
  std::string pace;
  if (done > 0 && !counted.empty()) {
    std::snprintf(text, sizeof text, "  %.1f M ", static_cast<double>(done) / seconds * 1e-6);
    pace += text + std::string(counted) + "/s";
  }
  if (fraction >= 0.01 && fraction < 1) {
    auto left = std::lround(seconds / fraction - seconds);
    std::snprintf(text, sizeof text, "  %ld:%02ld left", left / 60, left % 60);
    pace += text;
  }
  return pace;
}

} // namespace voxc::tool
