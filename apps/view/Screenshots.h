// Pictures as numbered files, written on a thread.
#pragma once

#include "view/LatestValue.h"

#include "voxc/Support/Error.h"
#include "voxc/Trace/Picture.h"

#include <functional>
#include <string>
#include <thread>

namespace voxc::view {

class Screenshots {
public:
  /// They go to `folder`. `wake` is called from the thread when there is something to take.
  Screenshots(std::string folder, std::function<void()> wake)
      : folder_(std::move(folder)), wake_(std::move(wake)) {}

  /// Writes `picture` to the next file "voxc-0001.png" that is not there yet. Waits for the one before, if
  /// that is still being written, and returns what was not taken of that.
  std::optional<Expected<std::string>> write(Picture picture);
  /// The path of the one that was written last. Error: `Environment`.
  std::optional<Expected<std::string>> take() { return written_.take(); }

private:
  std::string folder_;
  std::function<void()> wake_;
  int number_ = 0;
  LatestValue<Expected<std::string>> written_;
  std::jthread writer_; // The last: it uses all others.
};

} // namespace voxc::view
