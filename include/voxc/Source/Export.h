// Writing a volume to a file of any kind: its voxels as a dense grid, points or MagicaVoxel, or itself.
#pragma once

#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc {

/// Decodes `volume` to `path`, by its ending: .raw (uint32 RGBA, x fastest, of the input's extent), .ply
/// (binary points: int x y z, uchar red green blue alpha, one a voxel in Morton order) or .vox (MagicaVoxel;
/// at most 255 colours, several models of up to 256 cells a side). A path that ends in .hvx gets the volume
/// itself, as `Volume::save` writes it. Written under a temporary name and renamed. Errors: another ending;
/// `Usage`, `options.compress` for what is no .hvx; more voxels than the file or the disk can hold; as
/// `decode` and `save`.
Expected<void> exportVoxels(const Volume &volume, const std::string &path, const SaveOptions &options = {});

} // namespace voxc
