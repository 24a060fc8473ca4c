// What the program does: one function a command.
#pragma once

#include "LatticeSubject.h"

#include "voxc/Support/Error.h"

#include <string>
#include <vector>

namespace voxc::gpu {

/// What the command line says; each command looks at its own.
struct Options {
  std::string volume, folder, output, device, cameras, label, scene;
  std::vector<std::string> kernels, cudas, only;
  std::vector<std::uint32_t> groups;
  std::string peer, nodes;
  std::string size = "3840x2160";
  int side = 1024; ///< Pixels of a picture from a distance.
  double seconds = 0.1;
  bool atOnce = false, follows = false;
  LatticeOptions lattice;
  std::string programs;
};

/// Makes the rays of a scene, and the oracle's hits (RaySets.h). Errors: of reading, and of the options
/// (`Usage`).
Expected<void> makeRays(const Options &options);

/// Makes the rays of a camera from farther and farther away. Errors: of reading; a picture of no pixels
/// (`Usage`).
Expected<void> makeDistances(const Options &options);

/// Measures a volume with its kernels, or a tracer by hand, on all sets of a folder. Errors: of reading, and
/// of the device; a kernel that fails is told of in the figures.
Expected<void> measure(const Options &options);

/// Checks kernels on hard rays (LatticeSubject.h). Errors: as above, and `Input` if a hit is not the exact
/// one; then the figures are written all the same.
Expected<void> checkHardRays(const Options &options);

} // namespace voxc::gpu
