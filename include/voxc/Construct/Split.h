// Cutting a finished volume into the fragments that it could have been built from.
#pragma once

#include "voxc/Construct/Constructor.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <string>

namespace voxc {

/// Writes the parts of `volume` whose numbers, in Morton order, lie in the fragment `index` of `count` (0 to
/// count - 1) to `path`: `Constructor::merge` makes the same volume of all of them, byte for byte. Nothing is
/// decoded, and parts that are not taken are not looked at, so that a volume can be edited by building anew
/// what changed and taking the rest from here. The report has voxels and seconds. Errors: `Environment`, or
/// the work was stopped.
Expected<BuildReport> splitVolume(const Volume &volume, std::uint64_t index, std::uint64_t count,
                                  const std::string &path, const Progress &progress = {});

} // namespace voxc
