/* Pictures in C by kernels of files: loaded VOLUME.hvx KERNEL.spv... says of each what is in the middle. */
#include <voxc-c/voxc.h>

#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 33 };

/* Ends the program if something went wrong. */
static void check(voxc_error *error) {
  if (!error)
    return;
  fprintf(stderr, "loaded: %s\n", voxc_error_message(error));
  voxc_error_free(error);
  exit(1);
}

static void take(const voxc_volume *volume, const char *path) {
  static const double eye[] = {16.5, 16.5, 90}, look[] = {16.5, 16.5, 16.5};
  static uint32_t pixels[SIDE * SIDE];
  voxc_picture_options picture = VOXC_PICTURE_OPTIONS;
  voxc_tracer *tracer;
  voxc_error *error;
  check(voxc_tracer_load(volume, path, NULL, &tracer));
  picture.width = SIDE;
  picture.height = SIDE;
  picture.style = "flat";
  picture.eye = eye;
  picture.look = look;
  error = voxc_render(tracer, &picture, pixels);
  if (error)
    printf("%d: %s\n", (int)voxc_error_get_kind(error), voxc_error_message(error));
  else
    printf("%08x\n", (unsigned)pixels[SIDE * SIDE / 2]);
  voxc_error_free(error);
  voxc_tracer_free(tracer);
}

int main(int argc, char **argv) {
  voxc_volume *volume;
  int i;
  if (argc < 3)
    return 2;
  check(voxc_volume_load(argv[1], NULL, &volume));
  for (i = 2; i < argc; ++i)
    take(volume, argv[i]);
  voxc_volume_free(volume);
  return 0;
}
