// The progress bar.
#include "Terminal.h"

#include "Interrupt.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace voxc::tool {
namespace {

constexpr int kBarCells = 30;
constexpr std::chrono::milliseconds kRedraw{100};
constexpr const char *kEraseLine = "\r\x1b[K";

} // namespace

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() { clear(); }

Progress ProgressBar::progress() {
  Progress progress;
  progress.stop = &catchInterrupts();
  if (visible_)
    progress.report = [this](std::string_view stage, double fraction) { draw(stage, fraction); };
  return progress;
}

void ProgressBar::clear() {
  if (drawn_)
    std::fputs(kEraseLine, stderr);
  drawn_ = false;
}

void ProgressBar::draw(std::string_view stage, double fraction) {
  Clock::time_point now = Clock::now();
  if (drawn_ && stage == stage_ && now - lastDraw_ < kRedraw)
    return;
  stage_ = stage;
  lastDraw_ = now;
  drawn_ = true;
  double shown = std::clamp(fraction, 0.0, 1.0);
  int filled = static_cast<int>(shown * kBarCells);
  std::string bar = std::string(std::size_t(filled), '#') + std::string(std::size_t(kBarCells - filled), '.');
  std::fprintf(stderr, "%s%-12s [%s] %3d%%", kEraseLine, stage_.c_str(), bar.c_str(),
               static_cast<int>(shown * 100));
}

} // namespace voxc::tool
