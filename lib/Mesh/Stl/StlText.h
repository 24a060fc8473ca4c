// The text form of .stl.
#pragma once

#include "Mesh/MeshInput.h"
#include "Mesh/Polygon.h"
#include "Support/Problem.h"

namespace voxc {

/// Text has more digits than float32, which the binary form keeps.
using StlTextCorner = PolygonCutter::Point;

/// Appends the corners of all triangles. Problems: a word that does not belong where it stands, a number that
/// is none, a facet without end.
void readStlText(const MeshInput &input, ScratchArray<StlTextCorner> &corners, Problem &problem);

} // namespace voxc
