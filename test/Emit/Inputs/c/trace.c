/* trace RAYS FIRST SECOND: rays from a file through the words of two volumes of two formats, to hits as `voxc trace` writes them. */
#include "voxc_r2_2_2_g3_c.h"
#include "voxc_second_c.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct record {
  int32_t voxel[3];
  uint32_t colour;
  float t;
  uint32_t face;
};

static void *read_file(const char *path, size_t *bytes) {
  FILE *file = fopen(path, "rb");
  char *content = NULL;
  size_t got;
  *bytes = 0;
  do {
    content = realloc(content, *bytes + 65536);
    got = fread(content + *bytes, 1, 65536, file);
    *bytes += got;
  } while (got > 0);
  fclose(file);
  return content;
}

static void put(const int32_t voxel[3], uint32_t colour, float t, int found, int32_t axis, int32_t side) {
  struct record record;
  record.voxel[0] = voxel[0];
  record.voxel[1] = voxel[1];
  record.voxel[2] = voxel[2];
  record.colour = colour;
  record.t = t;
  record.face = !found ? 0 : axis < 0 ? 6 : (uint32_t)(2 * axis + (side > 0));
  fwrite(&record, sizeof record, 1, stdout);
}

/* What every hit must also say, by the other functions. */
static void check(int right, const char *what) {
  if (!right) {
    fprintf(stderr, "%s\n", what);
    exit(1);
  }
}

int main(int count, char **arguments) {
  size_t bytes, i;
  const float *rays = read_file(arguments[1], &bytes);
  const size_t rays_end = bytes / sizeof(float);
  const uint32_t *first = read_file(arguments[2], &bytes);
  const uint32_t *second = read_file(arguments[3], &bytes);
  check(count == 4, "three files");
  for (i = 0; i < rays_end; i += 6) {
    voxc_r2_2_2_g3_Hit hit, next;
    float normal[3], place[3];
    const bool found = voxc_r2_2_2_g3_closest(first, rays + i, rays + i + 3, 0, INFINITY, &hit);
    check(found == voxc_r2_2_2_g3_any(first, rays + i, rays + i + 3, 0, INFINITY), "any is not closest");
    next = hit;
    if (voxc_r2_2_2_g3_next(first, rays + i, rays + i + 3, INFINITY, &next))
      check(found && next.t >= hit.t, "next is nearer");
    voxc_r2_2_2_g3_normal(&hit, normal);
    check(hit.axis < 0 || normal[hit.axis] * (float)hit.side > 0, "the normal is of another face");
    voxc_r2_2_2_g3_outside(rays + i, rays + i + 3, &hit, place);
    check(hit.axis < 0 || (place[hit.axis] < (float)hit.voxel[hit.axis]) == (hit.side < 0), "the place is not outside");
    put(hit.voxel, hit.colour, hit.t, found, hit.axis, hit.side);
  }
  for (i = 0; i < rays_end; i += 6) {
    voxc_second_Hit hit;
    const bool found = voxc_second_closest(second, rays + i, rays + i + 3, 0, INFINITY, &hit);
    put(hit.voxel, hit.colour, hit.t, found, hit.axis, hit.side);
  }
  return 0;
}
