// Options of building, from C to C++.
#pragma once

#include "C/Handles.h"
#include "Support/ParallelFor.h"
#include "voxc/Construct/Constructor.h"

#include <voxc-c/voxc.h>

namespace voxc::c {

inline std::shared_ptr<WorkingMemory> memoryOf(const voxc_build_options &options) {
  return options.memory_bytes > 0 ? WorkingMemory::create(options.memory_bytes)
                                  : WorkingMemory::createDefault();
}

/// `progress` is the caller's, and outlives the build.
inline BuildOptions buildOptionsOf(const voxc_build_options &given, const Progress &progress) {
  BuildOptions options;
  options.provenance = textOr(given.provenance, "");
  options.threads = threadsOrAll(given.threads);
  options.path = textOr(given.path, "");
  options.progress = progress;
  options.compress = given.compress != 0;
  return options;
}

} // namespace voxc::c
