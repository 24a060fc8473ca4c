/* voxc in C, all of it: formats, building, kernels and pictures. What is said at the top of runtime.h holds
 * here too. */
#ifndef VOXC_C_VOXC_H
#define VOXC_C_VOXC_H

#include <voxc-c/runtime.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Formats. */

typedef struct voxc_format voxc_format;

/* Parses a format string, such as "R(4, 4, 4) G(5)", or the text of the level IR, and runs passes on it:
 * their names with commas between, such as "whole-level-dedup,palette=4"; null: none. Errors: what is wrong
 * with the text, with the place; an unknown pass. */
VOXC_API voxc_error *voxc_format_parse(const char *text, const char *passes, voxc_format **format);
/* The format of a volume. */
VOXC_API voxc_error *voxc_format_of_volume(const voxc_volume *volume, voxc_format **format);
VOXC_API void voxc_format_free(voxc_format *format);
/* In short, without its passes: "R(4, 4, 4) G(5)". */
VOXC_API const char *voxc_format_text(const voxc_format *format);
/* As the text of the level IR, with all that passes decided. */
VOXC_API const char *voxc_format_ir(const voxc_format *format);
/* The voxels that it holds along x, y and z. */
VOXC_API void voxc_format_extent(const voxc_format *format, int32_t extent[3]);

/* The traversal as functions, in one text of GLSL and C++ (docs/library.md). `name` is put into their names;
 * null: one that is made of the format. The text is the caller's, who frees it by voxc_free. Errors: no
 * possible name; a format of which functions cannot be, as one that stops above voxels. */
VOXC_API voxc_error *voxc_emit_header(const voxc_format *format, const char *name, char **text);
/* The same in one language: "shared" is that of voxc_emit_header, and there are "glsl", "essl", "cpp",
 * "cuda", "hlsl" and "wgsl"; null: "shared". Errors also: no such language. */
VOXC_API voxc_error *voxc_emit_header_in(const voxc_format *format, const char *language, const char *name,
                                         char **text);
/* The intersection kernel in GLSL. The text is the caller's, who frees it by voxc_free. */
VOXC_API voxc_error *voxc_emit_glsl(const voxc_format *format, char **text);
/* The same as SPIR-V, for any device: what voxc_tracer_load takes. The words are the caller's, who frees them
 * by voxc_free. */
VOXC_API voxc_error *voxc_compile_spirv(const voxc_format *format, uint32_t **words, size_t *count);

/* Building. */

typedef struct voxc_build_options {
  size_t struct_size;
  unsigned threads;       /* 0: all of the machine. */
  uint64_t memory_bytes;  /* That may be resident; what does not fit lies in a scratch file. 0: a quarter of
                           * the machine's. */
  const char *path;       /* Where the volume is written while it is built; null: it stays in memory. */
  int compress;           /* Compresses the file at `path`. */
  const char *provenance; /* Kept in the volume; null: what the input says. */
  const voxc_progress *progress; /* Null: none. */
} voxc_build_options;
#define VOXC_BUILD_OPTIONS {.struct_size = sizeof(voxc_build_options)}

/* Builds a dense grid of voxels, x fastest, then y, then z; 0 is empty. The grid is only read during the
 * call. Errors: an extent that is not from 1 to 2^21 an axis, or larger than the format. `options` may be
 * null here and below. */
VOXC_API voxc_error *voxc_build_grid(const voxc_format *format, const uint32_t *words,
                                     const int32_t extent[3], const voxc_build_options *options,
                                     voxc_volume **volume);

/* Builds a list of voxels: places[3 * i] to places[3 * i + 2] is that of words[i]. Of several at one place
 * the last counts, and a word of 0 leaves it empty. `extent` may be null: as far as the list reaches. Errors:
 * a place outside the extent or the format. */
VOXC_API voxc_error *voxc_build_voxels(const voxc_format *format, const int32_t *places,
                                       const uint32_t *words, uint64_t count, const int32_t *extent,
                                       const voxc_build_options *options, voxc_volume **volume);

/* Voxels by a function, for scenes that do not lie in memory. */
typedef struct voxc_source {
  int32_t extent[3];
  /* The word of a voxel inside the extent. It may be called by several threads at once. */
  uint32_t (*voxel)(void *user, int32_t x, int32_t y, int32_t z);
  /* 1 only if the cube of `side` voxels from (x, y, z) on has no voxel; null: nobody knows. Cubes may reach
   * outside. */
  int (*is_empty)(void *user, int32_t x, int32_t y, int32_t z, int32_t side);
  void *user;
} voxc_source;

VOXC_API voxc_error *voxc_build_source(const voxc_format *format, const voxc_source *source,
                                       const voxc_build_options *options, voxc_volume **volume);

/* What is to be reported of an input: sentences that the tools would print, by the thread that called. A
 * function may be null. */
typedef struct voxc_input_report {
  /* What of a file was left out, or taken otherwise than it may be meant. */
  void (*warning)(void *user, const char *sentence);
  /* What was done as asked for, or by default. */
  void (*note)(void *user, const char *sentence);
  void *user;
} voxc_input_report;

/* How a file becomes voxels: the options of `voxc build`. A member that is 0 or null has the default value of
 * the command line, and one that means nothing for the input at hand is an error, as there. */
typedef struct voxc_input_options {
  size_t struct_size;
  int32_t resolution; /* Voxels on the longest axis of a mesh; 0: what the format holds. */
  /* Which voxels of a mesh: "conservative" (null), all that a triangle touches; "thin", fewer; "inner", thin
   * with one where a face lies between two; or "centre", all whose centre lies in a closed mesh. */
  const char *coverage;
  int z_up; /* 1: +z is up; -1: +y is up; 0: by the kind of file. */
  /* Samples of a dense volume from here up are voxels; null: found by the histogram. */
  const double *threshold;
  /* Of a dense volume: "grey" (null), "heat", "dusk", "polar"; or "labels", also of MagicaVoxel models. */
  const char *colour_map;
  /* Of a mesh's texture: "mean" (null) of a voxel's texels, where they are finer than it, or "nearest". */
  const char *colour;
  /* In place of a resolution: the side of a voxel, a number in units of the model, or with a unit behind it.
   * A scan is made anew in such cubes. */
  const char *voxel_size;
  const char *unit; /* What a step of 1 in the model is, for a voxel_size with a unit; null: by the file. */
  const double *align;  /* Three numbers: a point of the model through which planes between voxels go. */
  const double *bounds; /* Crops a mesh to a box of model space: six numbers, the low corner first. */
  const double *window; /* Samples with the first and the last colour: two numbers; null: by the samples. */
  int32_t volume;       /* Which of several volumes or components of a scan, from 1 on; 0: the first. */
  const char *grid;     /* The grid of a NanoVDB file, or the array of a .npz; null: the first of a shape. */
  const char *interior; /* The inside of things: "keep" (null), "drop" or "fill". */
  const char *fill_colour;         /* Of voxels that fill the inside, as rrggbb or rrggbbaa; null: white. */
  int crop;                        /* 1: moves the smallest box around all voxels to the origin. */
  const voxc_input_report *report; /* Null: nothing is reported. */
} voxc_input_options;
#define VOXC_INPUT_OPTIONS {.struct_size = sizeof(voxc_input_options)}

/* Builds a mesh, points, MagicaVoxel models or a dense volume: all that `voxc build` takes as INPUT. Errors:
 * those of `voxc build`, in its words, which name options as "--voxel-size". */
VOXC_API voxc_error *voxc_build_input(const voxc_format *format, const char *input,
                                      const voxc_input_options *input_options,
                                      const voxc_build_options *options, voxc_volume **volume);

/* Choosing a format. */

/* What is asked of formats. */
typedef struct voxc_choice_options {
  size_t struct_size;
  /* "balanced" (null): twice the speed is worth four times the bytes; "fastest" or "smallest". */
  const char *objective;
  uint64_t max_bytes;    /* Of a volume's words; 0: what references can reach. */
  const char *device;    /* That will trace: its name, or part of it. Null: "cpu" of voxc_suggest, the best
                          * of voxc_search. */
  const char *precision; /* Of a search: "exact" (null) or "fast". */
  const char *const *formats; /* Those to choose from, */
  size_t format_count;        /* so many; 0: those that voxc knows, and of a search what it makes of them. */
  const voxc_ray *rays;       /* Rays that will be traced, */
  uint64_t ray_count;         /* 8 at least; 0: those of a camera that sees everything, and bounced ones. */
  int editable;               /* Of voxc_suggest: 1 for formats whose volumes can be edited in place. */
  double seconds;             /* That a search may take; 0: 180. */
  unsigned threads;           /* That build, and of "cpu"; 0: all of the machine. */
  uint64_t memory_bytes;      /* As voxc_build_options. */
  const voxc_progress *progress; /* Null: none. */
} voxc_choice_options;
#define VOXC_CHOICE_OPTIONS {.struct_size = sizeof(voxc_choice_options)}

/* Formats with their sizes and speeds, one a row. */
typedef struct voxc_format_table voxc_format_table;

/* Predicts what formats take and how fast they are, and builds none. Input and its options are those of
 * voxc_build_input, with a resolution of 512 by default. Errors: those of inputs; a text that is no format;
 * no format that takes so few bytes; a device that is not there and was never measured. */
VOXC_API voxc_error *voxc_suggest(const char *input, const voxc_input_options *input_options,
                                  const voxc_choice_options *options, voxc_format_table **table);
/* Builds and measures those formats that promise most, for so many seconds. What it learns of the device is
 * kept in the user's cache. Errors also: the time is too short for one format; there is no such device. */
VOXC_API voxc_error *voxc_search(const char *input, const voxc_input_options *input_options,
                                 const voxc_choice_options *options, voxc_format_table **table);
VOXC_API void voxc_format_table_free(voxc_format_table *table);

/* How many rows there are, how many voxels the scene has, and how many sets of rays with which names. */
VOXC_API size_t voxc_format_table_rows(const voxc_format_table *table);
VOXC_API uint64_t voxc_format_table_voxels(const voxc_format_table *table);
VOXC_API size_t voxc_format_table_sets(const voxc_format_table *table);
VOXC_API const char *voxc_format_table_set(const voxc_format_table *table, size_t set);

/* A row. Its texts belong to the table. */
typedef struct voxc_format_row {
  const char *format;  /* As voxc_format_parse takes it, */
  const char *passes;  /* with these, which have commas between. */
  uint64_t bytes;      /* Of its words. */
  int exact;           /* 1: not one more, not one less; what was measured is exact. */
  int frontier;        /* 1: no other row is as small and as fast, or better. */
  int chosen;          /* 1: what the objective asks for. */
  const char *failure; /* Of a search: why it has no speeds; null: it has. */
} voxc_format_row;
VOXC_API void voxc_format_table_row(const voxc_format_table *table, size_t row, voxc_format_row *values);

/* The speed of a row on a set of rays, in rays a second: of one core where a processor traces, of the device
 * else. What was not measured, or not predicted, is 0. */
typedef struct voxc_format_speed {
  double predicted;
  double measured;         /* The median of several rounds, */
  double slowest, fastest; /* and the least and the most of them. */
  uint64_t checked_rays;   /* Of which the oracle was asked, */
  uint64_t wrong_rays;     /* those with another hit, */
  double max_ulp;          /* and how far t is from the exact one at most, in units of its last place. */
} voxc_format_speed;
VOXC_API void voxc_format_table_speed(const voxc_format_table *table, size_t row, size_t set,
                                      voxc_format_speed *speed);

/* Editing. */

/* A volume that changes (docs/edits.md). One thread at a time edits it. */
typedef struct voxc_editable voxc_editable;

/* Copies the words of a volume, and makes its nodes known, so that new ones that are equal are not written.
 * Errors: a format that cannot be edited, naming what stands against it. */
VOXC_API voxc_error *voxc_editable_create(const voxc_volume *volume, voxc_editable **editable);
VOXC_API void voxc_editable_free(voxc_editable *editable);

/* Each of these does one edit as a whole; after an error nothing has changed. Voxels outside of the volume
 * stay empty. Errors: a word that the format cannot keep. A word of 0 clears. */
/* Voxels from `low` on, `size` along each axis. */
VOXC_API voxc_error *voxc_editable_set_box(voxc_editable *editable, const int32_t low[3],
                                           const int32_t size[3], uint32_t word);
/* Voxels whose centre is no farther than `radius`, 0 to 2^20, from that of the voxel `centre`. */
VOXC_API voxc_error *voxc_editable_set_sphere(voxc_editable *editable, const int32_t centre[3],
                                              int32_t radius, uint32_t word);
/* A list, as voxc_build_voxels takes it. Errors: a place below 0 or from 2^21 on. */
VOXC_API voxc_error *voxc_editable_set_voxels(voxc_editable *editable, const int32_t *places,
                                              const uint32_t *words, uint64_t count);
/* Another volume, whose voxels are put from `low` on; where it is empty nothing changes. */
VOXC_API voxc_error *voxc_editable_paste(voxc_editable *editable, const voxc_volume *volume,
                                         const int32_t low[3]);
/* Each voxel of a box becomes what `function` says of it. Within `function`, and within that of a progress,
 * editing, compacting, following or framing this volume is an error, and a restore does nothing; a snapshot
 * is of the state that the edit began with. It must not be freed there, and states from before may be viewed.
 */
VOXC_API voxc_error *voxc_editable_apply(voxc_editable *editable, const int32_t low[3], const int32_t size[3],
                                         uint32_t (*function)(void *user, int32_t x, int32_t y, int32_t z,
                                                              uint32_t word),
                                         void *user);

/* A state to come back to, until the editable is freed. It costs nothing. */
typedef struct voxc_snapshot {
  uint64_t root;
  uint64_t voxels;
} voxc_snapshot;
VOXC_API voxc_snapshot voxc_editable_snapshot(voxc_editable *editable);
/* Makes a state that of the volume again, be it older or newer: undo and redo. */
VOXC_API void voxc_editable_restore(voxc_editable *editable, voxc_snapshot snapshot);
/* A state as a volume of its own, which may be traced by other threads while edits go on. */
VOXC_API voxc_error *voxc_editable_view(voxc_editable *editable, voxc_snapshot snapshot,
                                        voxc_volume **volume);

/* The frames of the animation that it began with: how many there are, of which the first `most` are written.
 * 0 if it was none. */
VOXC_API uint64_t voxc_editable_frames(const voxc_editable *editable, voxc_snapshot *frames, uint64_t most);
/* A volume whose frames are these states, at least one; `voxc_volume_save` writes all of them. */
VOXC_API voxc_error *voxc_editable_framed(voxc_editable *editable, const voxc_snapshot *frames,
                                          uint64_t count, voxc_volume **volume);

/* How many voxels are not empty; the words of all states; 1 if those are more than half as many again as the
 * first volume had, so that a compaction would gain. */
VOXC_API uint64_t voxc_editable_voxels(const voxc_editable *editable);
VOXC_API uint64_t voxc_editable_words(const voxc_editable *editable);
VOXC_API int voxc_editable_wants_compaction(const voxc_editable *editable);
/* The volume of the voxels as they are: its bytes are those of any build of them. */
VOXC_API voxc_error *voxc_editable_compact(const voxc_editable *editable, const voxc_build_options *options,
                                           voxc_volume **volume);

/* Tracing and pictures. */

/* A tracer by a kernel that is compiled for this volume and device. The volume may be freed before the
 * tracer. */
VOXC_API voxc_error *voxc_tracer_create(const voxc_volume *volume, const voxc_tracer_options *options,
                                        voxc_tracer **tracer);

/* Makes a tracer go on with an editable volume as it is now: one of the volume that the editable was made of,
 * or that followed it before. Only words that are others since then are copied to a device, all after an
 * update; `copied_bytes` may be null. No other tracer may follow the same editable. A tracer of "cpu" reads
 * the words that edits change: it must not trace while an edit runs; one of a voxc_editable_view may. Errors:
 * an editable of another format, which changes nothing; the device has no room or fails, after which the
 * tracer can only be freed. */
VOXC_API voxc_error *voxc_tracer_follow(voxc_tracer *tracer, voxc_editable *editable, uint64_t *copied_bytes);

typedef struct voxc_picture_options {
  size_t struct_size;
  int32_t width;     /* 0: 1280. */
  int32_t height;    /* 0: 720. */
  const char *style; /* "lit" (null), "flat", "ao", "normals", "depth", "heatmap". */
  /* Where no eye is given: "auto" (null), "iso", "front", "back", "left", "right", "top", "bottom", "inside".
   */
  const char *view;
  const double *eye;   /* Three numbers, in voxels, */
  const double *look;  /* and the point looked at: both, or neither. */
  double vertical_fov; /* In degrees; 0: the view's own. */
  unsigned samples;    /* Rays a pixel; 0: the style's own. */
  const voxc_progress *progress;
  int orthographic; /* 1: parallel rays; what is further off does not look smaller. */
  /* What an orthographic picture shows from bottom to top, in voxels (in their shortest sides, where they are
   * no cubes), from 0.001 to 1e9: the picture is orthographic, and has no field of view. 0: what the view or
   * the field of view shows at the point looked at. */
  double view_height;
  /* Cuts, of a tracer with bounds (voxc_tracer_options): inner voxels show where others are cut away. */
  const double *clip_box; /* Shows what lies between two corners: six numbers, in voxels; null: all. */
  /* So many planes of four numbers: nx, ny, nz, d cuts away where nx x + ny y + nz z is less than d. */
  const double *clip_planes;
  size_t clip_plane_count;
} voxc_picture_options;
#define VOXC_PICTURE_OPTIONS {.struct_size = sizeof(voxc_picture_options)}

/* A picture by a tracer of the closest hits with voxel, t and colour: rows from the top, RGBA8 with R in the
 * low byte, as many as width times height. Errors: a tracer of another query or without colours; a style or
 * view that there is not; an eye without a point; a box that holds nothing; cuts for a tracer without bounds;
 * those of tracing. Using the tracer within the progress is an error there. */
VOXC_API voxc_error *voxc_render(voxc_tracer *tracer, const voxc_picture_options *options, uint32_t *pixels);

#ifdef __cplusplus
}
#endif

#endif
