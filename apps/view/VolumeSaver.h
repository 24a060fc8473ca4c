// Volumes as numbered files, built anew and written on a thread.
#pragma once

#include "view/LatestValue.h"

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace voxc::view {

/// What is to be saved; both stay as they are.
struct SavedVolume {
  std::shared_ptr<const Volume>
      frames; ///< All frames of an animation, which are written as they are; or null.
  std::shared_ptr<const Volume> volume; ///< Else this, as a build of its voxels makes it.
};

class VolumeSaver {
public:
  /// They go to `folder`. `wake` is called from the thread when there is something to take.
  VolumeSaver(std::string folder, std::function<void()> wake)
      : folder_(std::move(folder)), wake_(std::move(wake)) {}

  /// Writes to the next file "voxc-0001.hvx" that is not there yet. Waits for the one before, if that is
  /// still being written, and returns what was not taken of that.
  std::optional<Expected<std::string>> write(SavedVolume saved);
  /// The path of the one that was written last. Errors: those of building and of writing.
  std::optional<Expected<std::string>> take() { return written_.take(); }

private:
  std::string folder_;
  std::function<void()> wake_;
  int number_ = 0;
  LatestValue<Expected<std::string>> written_;
  std::jthread writer_; // The last: it uses all others.
};

} // namespace voxc::view
