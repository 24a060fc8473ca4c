// voxc_construct_entry.h: what the program that builds calls. The file that includes this has named `Volume`,
// its levels.
#pragma once

#include "voxc_construct.h"

// Returns the offset of the root sub-volume; 0 if there is no voxel.
extern "C" voxc::construct::uint32_t voxc_construct(const voxc::construct::Host *host) {
  voxc::construct::Build build(*host);
  return Volume::construct(build);
}

// Builds the aligned cube of 2^log2_side voxels a side at (x, y, z) apart from the rest.
extern "C" void voxc_construct_part(const voxc::construct::Host *host, int x, int y, int z, int log2_side) {
  voxc::construct::Build build(*host);
  Volume::part(build, {x, y, z}, log2_side);
}
