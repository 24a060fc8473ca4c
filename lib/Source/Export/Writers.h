// What writes each kind of export; the table in Export.cpp says which takes what.
#pragma once

#include "voxc/Source/Export.h"
#include "voxc/Support/File.h"
#include "voxc/Support/NumberedPath.h"

namespace voxc {

/// Each writes the whole content to a file and says in `exported` what it made.
using WriteExport = Expected<void>(const Volume &volume, OutputFile &file, const ExportOptions &options,
                                   Exported &exported);

/// Words as they lie in memory, which is little-endian on every machine that voxc runs on.
WriteExport writeGrid;
WriteExport writePoints;

/// Models of at most 256 cells a side, placed by a scene graph, with a palette. MagicaVoxel's up is +z, so +y
/// is turned to it. Errors: more than 255 colours, unless the options are lossy; more than 2^29 voxels.
WriteExport writeMagicaVoxel;

/// The same in several files, one for each cube of 1024 cells a side that holds voxels, each with a palette
/// of its own. Errors: more than 255 colours in one of them, unless the options are lossy; more than 2^29
/// voxels in one.
Expected<void> writeMagicaVoxelParts(const Volume &volume, const NumberedPath &path,
                                     const ExportOptions &options, Exported &exported);

/// A binary glTF 2.0 file of the volume's faces. Errors: more than 4 GiB; a pipe.
WriteExport writeSurface;

/// The same with a texture: fewer rectangles, and triangles that share whole edges. Errors: as that; more
/// faces than fit a texture.
WriteExport writeTexturedSurface;

/// A NanoVDB file of one RGBA8 grid. Errors: more than 2^31 leaves.
WriteExport writeNanoVdb;

/// VTK image data (.vti): a colour of 4 bytes for each cell, by zlib. Error: a pipe.
WriteExport writeVtkImage;

/// A picture for each z, of rows along x with y downwards, to the files that the pattern `path` names. Error:
/// more than 2^26 cells a picture; no pattern for several.
Expected<void> writeSlices(const Volume &volume, const std::string &path, const ExportOptions &options,
                           Exported &exported);

} // namespace voxc
