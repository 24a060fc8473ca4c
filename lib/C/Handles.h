// What the opaque objects of the C interface are, and how its functions are made: errors of all kinds become
// values.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Volume.h"

#include <voxc-c/runtime.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>

struct voxc_error {
  voxc::Error error;
};

struct voxc_volume {
  explicit voxc_volume(voxc::Volume made)
      : volume(std::make_shared<const voxc::Volume>(std::move(made))), format(toString(volume->format())),
        ir(printIr(volume->format())) {}

  std::shared_ptr<const voxc::Volume> volume;
  std::string format;
  std::string ir;
};

struct voxc_tracer {
  std::shared_ptr<const voxc::Volume> volume;
  std::unique_ptr<voxc::Device> device; ///< Outlives the tracer; null: this processor.
  std::unique_ptr<voxc::Tracer> tracer;
  voxc::Format format; ///< Of the kernel; without levels where it came from a file.
  std::string deviceName;
  unsigned threads = 0;
  bool follows = false; ///< The volume is an editable one, whose words change where they lie.
  bool isOther = false; ///< It was given another volume: what an editable has not changed may differ too.
  bool renders = false; ///< A picture is being made, whose progress calls the caller.
};

namespace voxc::c {

/// The error for which there is always memory. Nobody frees it.
inline voxc_error &outOfMemory() {
  static voxc_error error{Error::environment("there is not enough memory")};
  return error;
}

/// Calls what may fail, and returns null or its error; nothing is thrown across the interface.
template <typename Function> voxc_error *guarded(const Function &function) noexcept {
  try {
    const Expected<void> done = function();
    return done ? nullptr : new voxc_error{done.error()};
  } catch (const std::bad_alloc &) {
    return &outOfMemory();
  } catch (const std::exception &exception) {
    try {
      return new voxc_error{Error::environment(exception.what())};
    } catch (const std::bad_alloc &) {
      return &outOfMemory();
    }
  }
}

/// Hands a volume over, or says why there is none.
inline Expected<void> handOver(Expected<Volume> made, voxc_volume **volume) {
  if (!made)
    return made.error();
  *volume = new voxc_volume(std::move(*made));
  return {};
}

/// Options as the caller's library knew them; what it did not know, or all without options, is 0. Error: a
/// size that no options have.
template <typename Options> Expected<Options> optionsOf(const Options *given) {
  Options options{};
  if (given && given->struct_size <= sizeof given->struct_size)
    return Error::usage("the struct_size of options is " + std::to_string(given->struct_size) +
                        "; begin them with their macro, as VOXC_TRACER_OPTIONS, which sets it");
  if (given)
    std::memcpy(&options, given, std::min(given->struct_size, sizeof options));
  return options;
}

inline std::string textOr(const char *text, const char *fallback) { return text ? text : fallback; }

/// Error (`Usage`): a picture of the tracer is being made, and what calls is its progress.
Expected<void> checkIdle(const voxc_tracer &tracer);

/// Error (`Usage`): the tracer is of another format than a volume that it shall take.
Expected<void> checkTakes(const voxc_tracer &tracer, const Volume &volume);

/// A caller's progress as ours. It must outlive what reports to it.
class CallersProgress {
public:
  explicit CallersProgress(const voxc_progress *progress) {
    if (!progress || !progress->report)
      return;
    progress_.stop = &stop_;
    progress_.report = [this, given = *progress](std::string_view stage, double fraction,
                                                 std::uint64_t done) {
      if (given.report(given.user, std::string(stage).c_str(), fraction, done) != 0)
        stop_ = true;
    };
  }
  CallersProgress(const CallersProgress &) = delete;
  CallersProgress &operator=(const CallersProgress &) = delete;

  const Progress &get() const { return progress_; }

private:
  std::atomic<bool> stop_ = false;
  Progress progress_;
};

/// The device that options name; null: this processor, which is also meant where none is named and Vulkan has
/// none.
inline Expected<std::unique_ptr<Device>> openDevice(const voxc_tracer_options &options,
                                                    std::string_view processor) {
  const std::string name = textOr(options.device, "");
  if (name == processor)
    return std::unique_ptr<Device>();
  Expected<Device> device = Device::open(name);
  if (device)
    return std::make_unique<Device>(std::move(*device));
  if (name.empty())
    return std::unique_ptr<Device>();
  return device.error();
}

} // namespace voxc::c
