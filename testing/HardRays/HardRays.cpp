// The table of the classes of hard rays, and rays by class and by share.
#include "testing/HardRays.h"

#include "Families.h"
#include "RandomSource.h"

#include <algorithm>

namespace voxc::test {

namespace {

constexpr HardRayClass kClasses[] = {
    {"camera", "unit directions from outside towards the volume", cameraRay, 30},
    {"outside", "random lines from outside towards the volume", outsideRay, 20},
    {"inside", "random lines from inside, half of them from lattice points", insideRay, 20},
    {"axis-centre", "axis-parallel through the centres of cells", axisCentreRay, 8},
    {"axis-face", "axis-parallel within a plane between cells", axisFaceRay, 6},
    {"axis-edge", "axis-parallel along the edges of cells", axisEdgeRay, 4},
    {"diagonal", "through lattice points along small whole directions", diagonalRay, 12},
    {"corner", "through the corners and edges of the grid", cornerRay, 0},
    {"whole", "from lattice points along whole directions of up to 11 bits", wholeRay, 0},
    {"touch", "touching an edge or a corner of a voxel and nothing more of it", touchRay, 0},
    {"boundary-ulp", "a unit in the last place to either side of boundaries", boundaryUlpRay, 0},
    {"grazing", "almost parallel to a plane between cells, and close to it", grazingRay, 0},
    {"grazing-meet", "parallel to a plane between cells but for 1e-7, and meeting it", grazingMeetRay, 0},
    {"tunnel", "along a tunnel one cell wide, touching its walls", tunnelRay, 0},
    {"near-tie", "boundaries of two or three axes whose times agree in 40 bits", nearTieRay, 0},
    {"near-lattice", "close by lattice points along components of 24 bits", nearLatticeRay, 0},
    {"exact-tie", "boundaries crossed at exactly the same broken t", exactTieRay, 0},
    {"broken-tie", "the same but for an ulp", brokenTieRay, 0},
    {"tiny", "tiny and denormal components", tinyRay, 0},
    {"scaled", "directions scaled by up to 1e20 or down to 1e-20", scaledRay, 0},
    {"mixed", "components whose exponents have nothing in common", mixedRay, 0},
    {"far", "origins ten thousand to a million voxels away", farRay, 0},
    {"farthest", "origins up to a billion voxels away, aimed at the grid", farthestRay, 0},
    {"retreat", "other hard rays from 2 to 2^40 times the grid's size back on their lines", retreatRay, 0},
    {"large", "origins with coordinates about 2^21", largeRay, 0},
    {"huge", "components up to the largest float32", hugeRay, 0},
    {"on-boundary", "from faces, edges and corners of cells", onBoundaryRay, 0},
    {"solid", "from within voxels", solidRay, 0},
    {"far-face", "from the faces of the grid, inward, outward and along", farFaceRay, 0},
    {"signed-zero", "zeros of both signs in origin and direction", signedZeroRay, 0},
    {"still", "directions of zero length", stillRay, 0},
    {"not-finite", "an infinite component, or one that is not a number", notFiniteRay, 0},
};

const HardRayClass &shareHolder(unsigned percent) {
  const HardRayClass *row = kClasses;
  for (; percent >= row->verifyShare; ++row)
    percent -= row->verifyShare;
  return *row;
}

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

std::vector<Ray> verifyRays(Int3 extent, std::size_t count, std::uint64_t seed) {
  RandomSource random(seed);
  std::vector<Ray> rays(count);
  std::ranges::generate(rays, [&] {
    const auto percent = static_cast<unsigned>(random.integer(0, 99));
    return shareHolder(percent).make(random, extent);
  });
  return rays;
}

} // namespace voxc::test
