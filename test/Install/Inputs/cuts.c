/* Pictures in C of a volume that is cut, and by parallel rays: cuts VOLUME.hvx FOLDER writes their pixels. */
#include <voxc-c/voxc.h>

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static const double box[] = {0, 0, 0, 32, 32, 20.5}, empty_box[] = {4, 0, 0, 4, 9, 9};
static const double planes[] = {1, 0, 1, 20, 0, -1, 0, -25}, no_plane[] = {0, 0, 0, 1};
static const double eye[] = {60, 40, 70}, look[] = {16, 16, 16};

/* Ends the program if something went wrong. */
static void check(voxc_error *error) {
  if (!error)
    return;
  fprintf(stderr, "cuts: %s\n", voxc_error_message(error));
  voxc_error_free(error);
  exit(1);
}

static voxc_picture_options sized(void) {
  voxc_picture_options picture = VOXC_PICTURE_OPTIONS;
  picture.width = WIDTH;
  picture.height = HEIGHT;
  return picture;
}

static void take(voxc_tracer *tracer, const voxc_picture_options *picture, const char *folder, const char *name) {
  static uint32_t pixels[WIDTH * HEIGHT];
  char path[1024];
  FILE *file;
  check(voxc_render(tracer, picture, pixels));
  snprintf(path, sizeof path, "%s/%s.rgba", folder, name);
  file = fopen(path, "wb");
  if (!file || fwrite(pixels, 1, sizeof pixels, file) != sizeof pixels || fclose(file) != 0)
    exit(1);
}

/* Prints what a picture that cannot be is told. */
static void refuse(voxc_tracer *tracer, const voxc_picture_options *picture) {
  static uint32_t pixels[WIDTH * HEIGHT];
  voxc_error *const error = voxc_render(tracer, picture, pixels);
  printf("%s\n", error ? voxc_error_message(error) : "it is taken");
  voxc_error_free(error);
}

int main(int argc, char **argv) {
  voxc_volume *volume;
  voxc_tracer *tracer, *unbounded;
  voxc_tracer_options options = VOXC_TRACER_OPTIONS;
  voxc_picture_options picture = sized();
  if (argc != 3)
    return 2;
  check(voxc_volume_load(argv[1], NULL, &volume));
  options.device = "cpu";
  check(voxc_tracer_create(volume, &options, &unbounded));
  options.bounds = 1;
  check(voxc_tracer_create(volume, &options, &tracer));
  voxc_volume_free(volume);

  take(tracer, &picture, argv[2], "whole");
  picture.view = "iso";
  picture.clip_box = box;
  take(tracer, &picture, argv[2], "box");
  refuse(unbounded, &picture);
  picture.clip_planes = planes;
  picture.clip_plane_count = 2;
  picture.view_height = 40;
  take(tracer, &picture, argv[2], "all");
  picture.vertical_fov = 40;
  refuse(tracer, &picture);

  /* A program that was compiled before there were cuts hands over less. */
  picture = sized();
  memset((char *)&picture + offsetof(voxc_picture_options, orthographic), 0x55,
         sizeof picture - offsetof(voxc_picture_options, orthographic));
  picture.struct_size = offsetof(voxc_picture_options, orthographic);
  take(unbounded, &picture, argv[2], "older");

  picture = sized();
  picture.orthographic = 1;
  picture.eye = eye;
  picture.look = look;
  picture.vertical_fov = 30;
  take(unbounded, &picture, argv[2], "parallel");
  picture.look = eye;
  refuse(tracer, &picture);
  picture = sized();
  picture.clip_box = empty_box;
  refuse(tracer, &picture);
  picture = sized();
  picture.clip_planes = no_plane;
  picture.clip_plane_count = 1;
  refuse(tracer, &picture);
  picture = sized();
  picture.view = "inside";
  picture.orthographic = 1;
  refuse(tracer, &picture);
  picture = sized();
  picture.view_height = -1;
  refuse(tracer, &picture);
  voxc_tracer_free(tracer);
  voxc_tracer_free(unbounded);
  return 0;
}
