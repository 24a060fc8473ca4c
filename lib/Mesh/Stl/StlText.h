// The text form of .stl.
#pragma once

#include "Mesh/MeshInput.h"
#include "Support/Problem.h"

#include <array>

namespace voxc {

using StlCorner = std::array<float, 3>;

/// Appends the corners of all triangles. Problems: a word that does not belong where it stands, a number that
/// is none, a facet without end.
void readStlText(const MeshInput &input, ScratchArray<StlCorner> &corners, Problem &problem);

} // namespace voxc
