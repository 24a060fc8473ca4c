/* voxc in C: a ball of voxels by a function, two rays through it, and a picture. */
#include <voxc-c/voxc.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 64, CENTRE = 32, RADIUS = 24, WIDTH = 320, HEIGHT = 200 };

static uint32_t voxel(void *user, int32_t x, int32_t y, int32_t z) {
  const int32_t dx = x - CENTRE, dy = y - CENTRE, dz = z - CENTRE;
  const uint32_t colour = (uint32_t)(4 * x | 4 * y << 8 | 4 * z << 16) | 0xff000000u;
  (void)user;
  return dx * dx + dy * dy + dz * dz <= RADIUS * RADIUS ? colour : 0;
}

/* Ends the program if something went wrong. */
static void check(voxc_error *error) {
  if (!error)
    return;
  fprintf(stderr, "ball: %s\n", voxc_error_message(error));
  voxc_error_free(error);
  exit(1);
}

static void write_picture(const char *path, const uint32_t *pixels) {
  FILE *const file = fopen(path, "wb");
  if (!file)
    return;
  fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
  for (int i = 0; i < WIDTH * HEIGHT; ++i)
    fwrite(&pixels[i], 1, 3, file);
  fclose(file);
}

int main(int argc, char **argv) {
  voxc_format *format;
  check(voxc_format_parse("R(2, 2, 2) G(4)", "whole-level-dedup", &format));

  voxc_volume *volume;
  const voxc_source source = {.extent = {SIDE, SIDE, SIDE}, .voxel = voxel};
  check(voxc_build_source(format, &source, NULL, &volume));
  voxc_format_free(format);
  printf("%" PRIu64 " voxels in %" PRIu64 " bytes\n", voxc_volume_voxels(volume), voxc_volume_bytes(volume));

  voxc_tracer *tracer;
  voxc_tracer_options options = VOXC_TRACER_OPTIONS;
  options.device = argc > 2 ? argv[2] : "cpu";
  check(voxc_tracer_create(volume, &options, &tracer));
  voxc_volume_free(volume); /* The tracer keeps what it needs. */

  const voxc_ray rays[] = {{{-10.0f, 32.5f, 32.5f}, {1.0f, 0.0f, 0.0f}}, {{-10.0f, 1.5f, 32.5f}, {1.0f, 0.0f, 0.0f}}};
  voxc_hit hits[2];
  check(voxc_tracer_trace(tracer, rays, 2, hits));
  for (int i = 0; i < 2; ++i)
    if (hits[i].voxel[0] >= 0)
      printf("hit (%" PRId32 ", %" PRId32 ", %" PRId32 ") at t = %g\n", hits[i].voxel[0], hits[i].voxel[1],
             hits[i].voxel[2], hits[i].t);
    else
      printf("miss\n");

  if (argc > 1) {
    static uint32_t pixels[WIDTH * HEIGHT];
    voxc_picture_options picture = VOXC_PICTURE_OPTIONS;
    picture.width = WIDTH;
    picture.height = HEIGHT;
    check(voxc_render(tracer, &picture, pixels));
    write_picture(argv[1], pixels);
  }
  voxc_tracer_free(tracer);
}
