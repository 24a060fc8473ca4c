// Attributes of voxels from files, as voxc attach takes them.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Attributes.h"

#include <string>

namespace voxc::tool {

/// "NAME=INPUT": the words that an input has at the voxels of a volume, 0 where it has none. Samples of dense
/// volumes and numbers of palettes are taken as they are. Errors: another spelling, those of `openInput`, an
/// input of another extent, more than `mostBytes`, interrupted.
Expected<Attribute> wordsOfInput(const std::string &text, const Volume &volume, std::uint64_t mostBytes,
                                 const Progress &progress);

/// "NAME=MODEL": what the materials of a mesh or of MagicaVoxel models say at the voxels of a volume that was
/// made of it, by the options of the volume's provenance; NAME is "emission" (R, G and B in sRGB, then 255; 0
/// where there is none) or "metallic-roughness" (0, roughness, metallic, 255). Errors: as above, and a model
/// without such materials.
Expected<Attribute> materialOfInput(const std::string &text, const Volume &volume, std::uint64_t mostBytes,
                                    const Progress &progress);

/// "NAME:BYTES=FILE": the bytes of a file. Errors: another spelling, a file that cannot be read, or has other
/// than BYTES a voxel.
Expected<Attribute> dataOfFile(const std::string &text, const Volume &volume);

} // namespace voxc::tool
