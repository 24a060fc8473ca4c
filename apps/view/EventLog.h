// What the viewer tells while it runs, a line each.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Stopwatch.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace voxc::view {

class EventLog {
public:
  /// Tells on `out` (null: nowhere), and everything in the file `path` ("": none), which is made anew. Error:
  /// `Environment`, it cannot be written.
  static Expected<EventLog> open(std::FILE *out, const std::string &path);

  /// What somebody asked for: on both, at once.
  void tell(std::string_view line);
  /// What happened besides: in the file alone.
  void note(std::string_view line);

private:
  struct Closer {
    void operator()(std::FILE *file) const { std::fclose(file); }
  };

  std::FILE *out_ = nullptr;
  std::unique_ptr<std::FILE, Closer> file_;
  Stopwatch watch_; ///< Lines of the file begin with its seconds.
};

} // namespace voxc::view
