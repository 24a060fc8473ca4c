// The generated construction code as functions, each of which says whether it came to its end.
#pragma once

#include "BuildHost.h"

#include "voxc/Support/Error.h"

#include <cstdint>

namespace voxc {

/// Generated code has no errors: after a failure its host calls every cube empty, and it returns as if it
/// were done. So it is called through this alone.
class ConstructCode {
public:
  using Whole = std::uint32_t (*)(const construct::Host *host);
  using Part = void (*)(const construct::Host *host, int x, int y, int z, int log2Side);

  ConstructCode(Whole whole, Part part) : whole_(whole), part_(part) {}

  /// Builds a whole volume; returns what leads to its root. Error: the failure of the host's store.
  Expected<std::uint32_t> whole(BuildHost &host) const;
  /// Builds one part. Error: the same.
  Expected<void> part(BuildHost &host, const Cube &cube) const;

private:
  Whole whole_;
  Part part_;
};

} // namespace voxc
