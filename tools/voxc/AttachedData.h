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

/// "NAME:BYTES=FILE": the bytes of a file. Errors: another spelling, a file that cannot be read, or has other
/// than BYTES a voxel.
Expected<Attribute> dataOfFile(const std::string &text, const Volume &volume);

} // namespace voxc::tool
