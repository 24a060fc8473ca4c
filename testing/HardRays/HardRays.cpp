// The table of the classes of hard rays, and rays by class.
#include "testing/HardRays.h"

#include "Families.h"
#include "RandomSource.h"

#include <algorithm>

namespace voxc::test {

namespace {

constexpr HardRayClass kClasses[] = {
    {"camera", "unit directions from outside towards the volume", cameraRay},
    {"outside", "random lines from outside towards the volume", outsideRay},
    {"inside", "random lines from inside, half of them from lattice points", insideRay},
    {"axis-centre", "axis-parallel through the centres of cells", axisCentreRay},
    {"axis-face", "axis-parallel within a plane between cells", axisFaceRay},
    {"axis-edge", "axis-parallel along the edges of cells", axisEdgeRay},
    {"diagonal", "through lattice points along small whole directions", diagonalRay},
    {"corner", "through the corners and edges of the grid", cornerRay},
    {"whole", "from lattice points along whole directions of up to 11 bits", wholeRay},
    {"touch", "touching an edge or a corner of a voxel and nothing more of it", touchRay},
    {"boundary-ulp", "a unit in the last place to either side of boundaries", boundaryUlpRay},
    {"grazing", "almost parallel to a plane between cells, and close to it", grazingRay},
    {"grazing-meet", "parallel to a plane between cells but for 1e-7, and meeting it", grazingMeetRay},
    {"tunnel", "along a tunnel one cell wide, touching its walls", tunnelRay},
    {"near-tie", "boundaries of two or three axes whose times agree in 40 bits", nearTieRay},
    {"near-lattice", "close by lattice points along components of 24 bits", nearLatticeRay},
    {"exact-tie", "boundaries crossed at exactly the same broken t", exactTieRay},
    {"broken-tie", "the same but for an ulp", brokenTieRay},
    {"tiny", "tiny and denormal components", tinyRay},
    {"scaled", "directions scaled by up to 1e20 or down to 1e-20", scaledRay},
    {"mixed", "components whose exponents have nothing in common", mixedRay},
    {"far", "origins ten thousand to a million voxels away", farRay},
    {"farthest", "origins up to a billion voxels away, aimed at the grid", farthestRay},
    {"retreat", "other hard rays from 2 to 2^40 times the grid's size back on their lines", retreatRay},
    {"large", "origins with coordinates about 2^21", largeRay},
    {"huge", "components up to the largest float32", hugeRay},
    {"on-boundary", "from faces, edges and corners of cells", onBoundaryRay},
    {"solid", "from within voxels", solidRay},
    {"far-face", "from the faces of the grid, inward, outward and along", farFaceRay},
    {"signed-zero", "zeros of both signs in origin and direction", signedZeroRay},
    {"still", "directions of zero length", stillRay},
    {"not-finite", "an infinite component, or one that is not a number", notFiniteRay},
};

} // namespace

std::span<const HardRayClass> hardRayClasses() { return kClasses; }

std::vector<Ray> hardRays(const RayTarget &target, std::string_view className, std::size_t count,
                          std::uint64_t seed) {
  const auto row = std::ranges::find(kClasses, className, &HardRayClass::name);
  if (row == std::end(kClasses))
    return {};
  RandomSource random(seed);
  std::vector<Ray> rays(count);
  std::ranges::generate(rays, [&] { return row->make(random, target); });
  return rays;
}

} // namespace voxc::test
