/* Options and warnings of inputs in C: inputs ARRAYS.npz MESH.obj prints what it is told. */
#include <voxc-c/voxc.h>

#include <stddef.h>
#include <stdio.h>
#include <string.h>

static void print(void *user, const char *sentence) {
  printf("%s: warning: %s\n", (const char *)user, sentence);
}

/* Builds, and prints how many voxels there are, or the error. */
static void build(const char *name, const char *input, const voxc_input_options *options) {
  voxc_format *format = NULL;
  voxc_volume *volume = NULL;
  voxc_error *error = voxc_format_parse("G(3)", NULL, &format);
  if (!error)
    error = voxc_build_input(format, input, options, NULL, &volume);
  if (error)
    printf("error %d: %s\n", voxc_error_get_kind(error), voxc_error_message(error));
  else
    printf("%s: %d voxels\n", name, (int)voxc_volume_voxels(volume));
  voxc_error_free(error);
  voxc_volume_free(volume);
  voxc_format_free(format);
}

int main(int count, char **words) {
  voxc_input_report report = {print, NULL, NULL};
  voxc_input_options options = VOXC_INPUT_OPTIONS, none = VOXC_INPUT_OPTIONS;
  if (count != 3)
    return 2;
  report.user = "first";
  options.report = &report;
  build("first", words[1], &options);
  options.grid = "second";
  build("second", words[1], &options);
  build("nobody is told", words[1], NULL);
  /* A program that was built when the members ended here. */
  options.struct_size = offsetof(voxc_input_options, colour);
  build("of an older program", words[1], &options);

  options = none;
  options.colour = "nearest";
  build("colour", words[1], &options);
  options = none;
  options.voxel_size = "5 parsecs";
  build("size", words[2], &options);
  options = none;
  options.volume = -1;
  build("volume", words[1], &options);
  options = none;
  options.colour = "best";
  build("colour", words[2], &options);
  return 0;
}
