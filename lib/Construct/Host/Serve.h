// Work for generated code, which no exception can leave.
#pragma once

#include "voxc/Support/Error.h"

#include <new>

namespace voxc {

/// Calls `work(host)` of the host at `self`: where there is no memory its store fails, and the code gets
/// `otherwise`.
template <typename Host, typename Result, typename Work>
Result serve(void *self, Result otherwise, const Work &work) {
  Host &host = *static_cast<Host *>(self);
  try {
    return work(host);
  } catch (const std::bad_alloc &) {
    host.store().fail(Error::environment("out of memory"));
    return otherwise;
  }
}

/// The same for what returns nothing.
template <typename Host, typename Work> void serve(void *self, const Work &work) {
  serve<Host>(self, true, [&](Host &host) {
    work(host);
    return true;
  });
}

} // namespace voxc
