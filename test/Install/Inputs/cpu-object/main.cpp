// Traces two rays through a volume with a kernel that was compiled ahead, and then one that is of another format.
#include "intersect.h"

#include <voxc/Trace/CpuKernel.h>

#include <cstdio>

int main(int, char **arguments) {
  const auto volume = voxc::Volume::load(arguments[1]);
  if (!volume)
    return 1;
  const voxc::CpuKernel kernel{voxc_intersect, VOXC_INTERSECT_STORAGE_DIGEST, nullptr};
  for (const voxc::Ray &ray :
       {voxc::Ray{{-1, 0.5f, 0.5f}, {1, 0, 0}}, voxc::Ray{{-1, 9.5f, 0.5f}, {1, 0, 0}}}) {
    const auto hit = intersect(*volume, kernel, ray);
    if (!hit)
      std::printf("%s\n", hit.error().message.c_str());
    else if (hit->isHit())
      std::printf("hit (%d, %d, %d) at t = %g\n", hit->voxel[0], hit->voxel[1], hit->voxel[2],
                  double(hit->t));
    else
      std::printf("miss\n");
  }
}
