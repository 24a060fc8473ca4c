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
constexpr int kDefaultColumns = 80;
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

std::string printable(std::string text) {
  std::ranges::replace_if(text, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}

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
  double seconds = std::chrono::duration<double>(now - stageBegin_).count();
  // A line that wraps could not be erased.
  std::fprintf(stderr, "%s%s", kEraseLine,
               barText(stage_, shown, paceOf(seconds, shown, done, countedIn(stage)),
                       std::max(terminalColumns(STDERR_FILENO, kDefaultColumns) - 1, 1))
                   .c_str());
}

std::string barText(std::string_view stage, double fraction, const Pace &pace, int columns) {
  constexpr int kStageColumns = 12, kLeastCells = 4;
  char percent[8];
  std::snprintf(percent, sizeof percent, " %3d%%", static_cast<int>(fraction * 100));
  std::string head(stage), tail = percent + pace.rate + pace.left;
  head.resize(std::max<std::size_t>(head.size(), kStageColumns), ' ');
  const auto cellsLeft = [&] {
    constexpr int kFrame = 3; // " [" and "]".
    return columns - static_cast<int>(head.size() + tail.size()) - kFrame;
  };
  if (cellsLeft() < kLeastCells)
    tail = percent + pace.left;
  if (const int cells = std::min(cellsLeft(), kBarCells); cells >= kLeastCells) {
    const auto filled = static_cast<std::size_t>(fraction * cells);
    return head + " [" + std::string(filled, '#') + std::string(std::size_t(cells) - filled, '.') + "]" +
           tail;
  }
  const auto room = static_cast<std::size_t>(std::max(columns, 0));
  head.resize(room > tail.size() ? std::min(stage.size(), room - tail.size()) : 0);
  return (head + tail).substr(0, room);
}

Pace paceOf(double seconds, double fraction, std::uint64_t done, std::string_view counted) {
  // Before half a second or a hundredth of the way any number would be a guess.
  if (seconds < 0.5)
    return {};
  char text[64];
  Pace pace;
  if (done > 0 && !counted.empty()) {
    std::snprintf(text, sizeof text, "  %.1f M ", static_cast<double>(done) / seconds * 1e-6);
    pace.rate = text + std::string(counted) + "/s";
  }
  if (fraction >= 0.01 && fraction < 1) {
    auto left = std::lround(seconds / fraction - seconds);
    std::snprintf(text, sizeof text, "  %ld:%02ld left", left / 60, left % 60);
    pace.left = text;
  }
  return pace;
}

} // namespace voxc::tool
