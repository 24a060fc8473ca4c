// Colours that are not kept as they were: --lossy, and telling by how much.
#pragma once

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Source/Rounding.h"
#include "voxc/Volume/Volume.h"

#include <memory>
#include <string>

namespace voxc::tool {

/// What provenance says of colours that were reduced to those of a palette.
inline constexpr const char *kReducedColours = "reduced";

/// "largest error of R, G, B and alpha 4, 2, 4 and 0 of 255, mean 1.94, ...".
std::string errorText(const ColourError &error);
/// `largest`, `mean` and `rms`, of R, G, B and alpha.
Json errorFigures(const ColourError &error);

/// A source in the colours of a palette of the format's size that stand best for its own; null if it has no
/// more than that already. Errors: the format has no palette (`Usage`); the source's.
Expected<std::unique_ptr<RoundedSource>> reduceToPalette(VoxelSource &source, const Format &format,
                                                         const Progress &progress);

/// An input in the colours that a volume was to keep of it; null if these are all. Errors: as
/// `reduceToPalette`.
Expected<std::unique_ptr<RoundedSource>> asKept(const Volume &volume, VoxelSource &source,
                                                const Progress &progress);

} // namespace voxc::tool
