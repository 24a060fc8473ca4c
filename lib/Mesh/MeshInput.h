// What every mesh reader is given.
#pragma once

#include "Support/PathEnding.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Progress.h"

#include <memory>
#include <string>

namespace voxc {

/// A mesh file that is open, and where its contents shall go.
struct MeshInput {
  std::string path;
  std::shared_ptr<const WatchedFile> file;
  std::shared_ptr<WorkingMemory> memory;
  Progress progress;
  bool wantsMetal = false; ///< Textures of metal and roughness are read.

  /// The folder of the file, with a slash at its end; or empty.
  std::string folder() const { return folderOf(path); }

  /// Tells how far the reader is; false if it shall stop. Also keeps memory within its bound: to be called
  /// for every few kilobytes.
  bool at(std::uint64_t done, std::uint64_t all) const {
    memory->relieve();
    progress.at("load", all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all));
    return !progress.stopped();
  }
};

} // namespace voxc
