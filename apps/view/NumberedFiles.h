// Files that the viewer writes one after the other: pictures, volumes.
#pragma once

#include "view/LatestValue.h"

#include "voxc/Support/Error.h"

#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace voxc::view {

/// "voxc-0001.png" and so on in a folder, each written on a thread.
class NumberedFiles {
public:
  /// `wake` is called from the thread when there is something to take.
  NumberedFiles(std::string folder, std::string ending, std::function<void()> wake)
      : folder_(std::move(folder)), ending_(std::move(ending)), wake_(std::move(wake)) {}

  /// Has `write` write the next file that is not there yet. Waits for the one before, if that is still being
  /// written, and returns what was not taken of that.
  std::optional<Expected<std::string>> write(std::function<Expected<void>(const std::string &path)> write);
  /// The path of the one that was written last. Errors: those of writing.
  std::optional<Expected<std::string>> take() { return written_.take(); }

private:
  std::string nextPath();

  std::string folder_, ending_;
  std::function<void()> wake_;
  int number_ = 0;
  LatestValue<Expected<std::string>> written_;
  std::jthread writer_; // The last: it uses all others.
};

} // namespace voxc::view
