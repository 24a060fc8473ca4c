/* Formats of an input, predicted and measured in C: each row as a line. */
#include <voxc-c/voxc.h>

#include <stdio.h>
#include <stdlib.h>

static void check(voxc_error *error) {
  if (!error)
    return;
  fprintf(stderr, "choosing: %s (%d)\n", voxc_error_message(error), (int)voxc_error_get_kind(error));
  voxc_error_free(error);
  exit(1);
}

static void print_rows(const voxc_format_table *table) {
  for (size_t row = 0; row < voxc_format_table_rows(table); ++row) {
    voxc_format_row values;
    voxc_format_table_row(table, row, &values);
    printf("%s with %s: %llu bytes%s%s%s", values.format, values.passes, (unsigned long long)values.bytes,
           values.exact ? "" : " about", values.frontier ? ", frontier" : "", values.chosen ? ", chosen" : "");
    for (size_t set = 0; set < voxc_format_table_sets(table); ++set) {
      voxc_format_speed speed;
      voxc_format_table_speed(table, row, set, &speed);
      printf(", %s %s %s, %llu of %llu wrong", voxc_format_table_set(table, set),
             speed.predicted > 0 ? "predicted" : "-", speed.measured > 0 ? "measured" : "-",
             (unsigned long long)speed.wrong_rays, (unsigned long long)speed.checked_rays);
    }
    printf("\n");
  }
}

/* choosing INPUT FORMAT...: what is predicted of the formats, then what is measured of them. */
int main(int count, char **arguments) {
  voxc_input_options input = VOXC_INPUT_OPTIONS;
  input.resolution = 32;
  voxc_choice_options options = VOXC_CHOICE_OPTIONS;
  options.formats = (const char *const *)(arguments + 2);
  options.format_count = (size_t)(count - 2);
  options.device = "cpu";
  options.objective = "smallest";
  options.seconds = 120;

  voxc_format_table *table;
  check(voxc_suggest(arguments[1], &input, &options, &table));
  printf("%llu voxels\n", (unsigned long long)voxc_format_table_voxels(table));
  print_rows(table);
  voxc_format_table_free(table);
  check(voxc_search(arguments[1], &input, &options, &table));
  print_rows(table);
  voxc_format_table_free(table);
  return 0;
}
