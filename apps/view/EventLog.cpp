// Lines of events.
#include "view/EventLog.h"

#include <cerrno>
#include <cstring>

namespace voxc::view {

Expected<EventLog> EventLog::open(std::FILE *out, const std::string &path) {
  EventLog log;
  log.out_ = out;
  if (!path.empty()) {
    log.file_.reset(std::fopen(path.c_str(), "w"));
    if (!log.file_)
      return Error::environment("cannot write " + path + ": " + std::strerror(errno));
  }
  return log;
}

void EventLog::tell(std::string_view line) {
  if (out_) {
    std::fprintf(out_, "%.*s\n", int(line.size()), line.data());
    std::fflush(out_);
  }
  note(line);
}

void EventLog::note(std::string_view line) {
  if (!file_)
    return;
  std::fprintf(file_.get(), "%9.3f %.*s\n", watch_.seconds(), int(line.size()), line.data());
  std::fflush(file_.get());
}

} // namespace voxc::view
