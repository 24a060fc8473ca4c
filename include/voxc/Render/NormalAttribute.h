// Normals of voxels as an attribute, packed into four bytes each.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Attributes.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace voxc {

/// A direction as a place on an octahedron that is unfolded to a square, its two coordinates as signed 16-bit
/// fractions, x in the low half, as GLSL's packSnorm2x16 puts them: off by less than 0.02 degrees (Z. Cigolle
/// et al., "A Survey of Efficient Representations for Independent Unit Vectors", 2014). A direction of
/// length 0 is packed as 0x80008000, which no other is.
std::uint32_t packNormal(const glm::vec3 &direction);

/// The direction, of length 1, or 0.
glm::vec3 unpackNormal(std::uint32_t packed);

/// The attribute `normal`: the direction of the surface at each voxel, as `SurfaceNormals` finds it, to the
/// side with more room; 0 where the voxels around give none. Errors: more than `mostBytes`; interrupted.
Expected<Attribute> normalAttribute(const Volume &volume, unsigned threads, const Progress &progress = {},
                                    std::uint64_t mostBytes = kMostAttributeBytes);

} // namespace voxc
