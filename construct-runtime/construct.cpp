// construct.cpp: builds volumes of the format ${FORMAT}.
#include "voxc_construct.h"

using namespace voxc::construct;

namespace {
${LEVELS}
} // namespace

// Returns the offset of the root sub-volume; 0 if there is no voxel.
extern "C" uint32_t voxc_construct(const Host *host) {
  Build build(*host);
  return construct_level_1(build, {});
}

// Builds the aligned cube of 2^log2_side voxels a side at (x, y, z) apart from the rest.
extern "C" void voxc_construct_part(const Host *host, int x, int y, int z, int log2_side) {
  Build build(*host);
${PARTS}}
