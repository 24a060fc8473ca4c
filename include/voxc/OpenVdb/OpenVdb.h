// The optional component that reads and writes OpenVDB files.
#pragma once

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

namespace voxc {

/// Reads the first grid of 32-bit floats of a .vdb file. In a level set the voxels are those on the surface
/// and inside it, values up to `threshold` (default: half a voxel), in opaque white; in any other grid those
/// of a dense volume. The low corner of the box of active voxels lies at (0, 0, 0). Memory that OpenVDB takes
/// is not bounded. Errors: unreadable, no such grid, more than 2^42 cells in the box, larger than the format.
InputKind openVdbKind();

/// Writes two grids of the voxels to a .vdb file, as renderers of fog and smoke take them: `density`, a fog
/// volume of floats that is 1 where there is a voxel, and `Cd`, its colour in three floats from 0 to 1. The
/// grids lie in OpenVDB's memory, which is not bounded. Errors: as `decode` and `OutputFile`.
OtherExport openVdbExport();

} // namespace voxc
