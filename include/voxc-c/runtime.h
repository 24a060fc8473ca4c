/* voxc in C, without its compiler: volumes, devices, and kernels that lie in files.
 *
 * Functions that can fail return an error, which the caller frees, or null. What a function makes is handed
 * over through its last argument, and is untouched by a failure. Objects are freed by the function named
 * after them, which takes null too. Different objects may be used by different threads at once; one volume by
 * many, everything else by one at a time. Texts are UTF-8 and end with a zero byte; those that are returned
 * belong to their object, unless it says otherwise. */
#ifndef VOXC_C_RUNTIME_H
#define VOXC_C_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define VOXC_API __attribute__((visibility("default")))

/* Programs that were compiled with one number run with every library of the same number. */
#define VOXC_ABI_VERSION 0

/* VOXC_ABI_VERSION of the library that runs. */
VOXC_API uint32_t voxc_abi_version(void);
/* Its version, such as "0.1.0". */
VOXC_API const char *voxc_version(void);

/* Errors. */

typedef struct voxc_error voxc_error;

typedef enum voxc_error_kind {
  VOXC_ERROR_INPUT = 1,         /* The input is wrong, or a check failed. */
  VOXC_ERROR_USAGE = 2,         /* The call itself is wrong. */
  VOXC_ERROR_ENVIRONMENT = 3,   /* The machine lacks something: a device, memory, a permission. */
  VOXC_ERROR_INTERRUPTED = 130, /* The caller's progress function asked to stop. */
} voxc_error_kind;

VOXC_API voxc_error_kind voxc_error_get_kind(const voxc_error *error);
/* One sentence in lower case, or several lines that point into a text. */
VOXC_API const char *voxc_error_message(const voxc_error *error);
VOXC_API void voxc_error_free(voxc_error *error);

/* Frees what a function returned as a block of its own: texts and words of which that is said. */
VOXC_API void voxc_free(void *block);

/* How long work reports where it is, and asks whether to go on: `report` returns 0, or anything else to end
 * the work with VOXC_ERROR_INTERRUPTED. It gets the stage's name, its finished share from 0 to 1, and how
 * many things are done; 0 where nothing is counted. It may be called by other threads than the caller's, one
 * at a time. */
typedef struct voxc_progress {
  int (*report)(void *user, const char *stage, double fraction, uint64_t done);
  void *user;
} voxc_progress;

/* Structures of options begin with their size, and are begun with their macro: a library that is newer than
 * the program knows by it which members there are. A member that is 0 has its default value. */

/* Volumes. */

typedef struct voxc_volume voxc_volume;

typedef struct voxc_load_options {
  size_t struct_size;
  int trusted;         /* Leaves out the proof that every offset is right: for files of one's own. */
  unsigned threads;    /* That decode a compressed file; 0: all of the machine. */
  uint64_t most_cubes; /* Uniform cubes that decoding may find; 0: 2^34. A small file may stand for 2^60. */
  const voxc_progress *progress; /* Null: none. */
  int32_t frame; /* Of an animation, from 1 on: the volume is this frame alone. 0: the first, beside all
                    others. */
} voxc_load_options;
#define VOXC_LOAD_OPTIONS {.struct_size = sizeof(voxc_load_options)}

/* Opens a .hvx file. `options` may be null. Errors: no such file, one that is broken, or no such frame. */
VOXC_API voxc_error *voxc_volume_load(const char *path, const voxc_load_options *options,
                                      voxc_volume **volume);
VOXC_API void voxc_volume_free(voxc_volume *volume);
/* Writes a .hvx file under a temporary name and renames it: `path` is whole, or unchanged. `compress` is 0
 * or 1. */
VOXC_API voxc_error *voxc_volume_save(const voxc_volume *volume, const char *path, int compress);

/* The digest of its format's storage, which says how its words lie: kernels and emitted functions are for
 * this volume if theirs (VOXC_..._STORAGE_DIGEST in voxc_..._c.h) is the same, and else must not read its
 * words. */
VOXC_API uint64_t voxc_volume_digest(const voxc_volume *volume);
/* Its format in short, without its passes: "R(4, 4, 4) G(5)". */
VOXC_API const char *voxc_volume_format(const voxc_volume *volume);
/* The same as the text of the level IR, with all that passes decided. */
VOXC_API const char *voxc_volume_ir(const voxc_volume *volume);
/* How it was made, as "name=value" with blanks between; may be empty. */
VOXC_API const char *voxc_volume_provenance(const voxc_volume *volume);
/* Voxels of the input along x, y and z; the rest of the format is padding. */
VOXC_API void voxc_volume_extent(const voxc_volume *volume, int32_t extent[3]);
/* Of those that are not empty. */
VOXC_API uint64_t voxc_volume_voxels(const voxc_volume *volume);
/* How many frames it has (docs/edits.md, Frames), of which it shows the first; 1 if it is no animation. */
VOXC_API uint64_t voxc_volume_frames(const voxc_volume *volume);
/* Of all its streams together. */
VOXC_API uint64_t voxc_volume_bytes(const voxc_volume *volume);
/* The words that kernels read. They live as long as the volume. */
VOXC_API const uint32_t *voxc_volume_words(const voxc_volume *volume, uint64_t *count);
/* The elements of an attribute (docs/attributes.md), one for each voxel by its number, and how many bytes
 * one has; null if there is no such attribute. They live as long as the volume. */
VOXC_API const void *voxc_volume_attribute(const voxc_volume *volume, const char *name,
                                           uint32_t *element_bytes);
/* The same volume with an attribute more, or in place of one of that name: voxc_volume_voxels elements, which
 * are copied. Both volumes may be freed in any order. Errors: no possible name, 0 or more than 256 bytes. */
VOXC_API voxc_error *voxc_volume_with_attribute(const voxc_volume *volume, const char *name,
                                                uint32_t element_bytes, const void *elements,
                                                voxc_volume **result);
/* The matrix from voxels to the units of the model: three rows of four, the last of each the translation. */
VOXC_API void voxc_volume_to_model(const voxc_volume *volume, double rows[12]);
/* One voxel: RGBA8 with R in the low byte, or a label; 0 is empty, and so is all outside. */
VOXC_API uint32_t voxc_volume_lookup(const voxc_volume *volume, const int32_t voxel[3]);
/* The voxels of a box, from `low` on, x fastest, then y, then z: size[0] * size[1] * size[2] words. Error: a
 * size below 0 or of more than 2^40 voxels. */
VOXC_API voxc_error *voxc_volume_read(const voxc_volume *volume, const int32_t low[3], const int32_t size[3],
                                      uint32_t *words);
/* All voxels that are not empty, in Morton order (of two places, that comes first which is less in the
 * highest bit in which they differ, where a bit of z counts more than that of y, and that more than that of
 * x): voxc_volume_voxels of them, of which number i lies at places[3 * i] to places[3 * i + 2] and has
 * words[i]. Either may be null. voxc_build_voxels takes the same. */
VOXC_API voxc_error *voxc_volume_list(const voxc_volume *volume, int32_t *places, uint32_t *words);

/* Devices. */

typedef struct voxc_device_info {
  char name[256];
  char kind[32]; /* "discrete gpu", "integrated gpu", "virtual gpu", "cpu" or "other". */
  char uuid[40]; /* 32 hexadecimal digits; "" where there is none. */
  uint64_t memory_bytes;
  int usable; /* 1, or 0 if it lacks what voxc asks of a device. */
} voxc_device_info;

/* The devices of Vulkan, then "cpu", this processor without Vulkan. Writes at most `capacity` of them, and
 * returns how many there are. */
VOXC_API size_t voxc_devices(voxc_device_info *devices, size_t capacity);

/* Rays and hits, as they lie in files. */

typedef struct voxc_ray {
  float origin[3];    /* In voxels. */
  float direction[3]; /* Of any length: t counts in it. */
} voxc_ray;

/* A ray and the moments between which voxels are looked for. It enters a voxel at one moment, 0 if it begins
 * in it; that exact t, and not the rounded one of the hit, is compared with both, which belong to the
 * interval. A tmin below 0 is as good as 0; nothing lies in an interval that is empty or has a NaN at an end.
 */
typedef struct voxc_bounded_ray {
  float origin[3]; /* In voxels. */
  float tmin;
  float direction[3]; /* Of any length: t counts in it. */
  float tmax;         /* May be INFINITY. */
} voxc_bounded_ray;

typedef struct voxc_hit {
  int32_t voxel[3]; /* -1, -1, -1 of a miss, whose other members are 0. */
  uint32_t rgba;    /* Or a label. */
  float t;          /* When the ray enters the voxel, correctly rounded; 0 if it begins there. */
  uint32_t face; /* By which it enters, if that was asked: twice the axis, and 1 more for the high one; 6: it
                  * begins in the voxel. Else 0. */
} voxc_hit;

typedef struct voxc_tracer voxc_tracer;

typedef struct voxc_tracer_options {
  size_t struct_size;
  const char *device; /* "cpu"; a part of a name, a number or a UUID of a device of Vulkan; null or "": the
                       * best of Vulkan, and "cpu" where there is none. */
  unsigned threads;   /* Of this processor, where that traces or brings rays in order; 0: all. */
  /* The rest is for kernels that voxc_tracer_create makes. */
  const char *query; /* "closest" (null), "any", "occupancy" or "distance". */
  const char
      *outputs; /* What is stored of the closest hit, as "voxel,t,colour" (null); "face" may be among it. */
  const char *precision; /* "exact" (null) or "fast". */
  const char *passes; /* Passes that choose the traversal, with commas between; null: those of the format. */
  int bounds;         /* 1: for voxc_tracer_trace_bounded. */
} voxc_tracer_options;
#define VOXC_TRACER_OPTIONS {.struct_size = sizeof(voxc_tracer_options)}

/* A tracer by a kernel of `voxc compile --emit=spirv`, on a device of Vulkan. The volume may be freed before
 * the tracer. Errors: the kernel is of another format; the device has no room. */
VOXC_API voxc_error *voxc_tracer_load(const voxc_volume *volume, const char *kernel_path,
                                      const voxc_tracer_options *options, voxc_tracer **tracer);
VOXC_API void voxc_tracer_free(voxc_tracer *tracer);
/* The name of the device that it traces on. */
VOXC_API const char *voxc_tracer_device(const voxc_tracer *tracer);
/* Traces rays[i] into hits[i], `count` of them. A tracer with bounds takes them as those of [0, INFINITY]. */
VOXC_API voxc_error *voxc_tracer_trace(voxc_tracer *tracer, const voxc_ray *rays, uint64_t count,
                                       voxc_hit *hits);
/* The same of rays with bounds. Error: the tracer was made without (voxc_tracer_options, or its kernel). */
VOXC_API voxc_error *voxc_tracer_trace_bounded(voxc_tracer *tracer, const voxc_bounded_ray *rays,
                                               uint64_t count, voxc_hit *hits);
/* The normal of a hit's face, out of the voxel; 0, 0, 0 where there is none. */
VOXC_API void voxc_face_normal(uint32_t face, float normal[3]);

/* Takes another volume of the same format, as an edited one is, in place of its own: from then on hits are
 * those of a tracer that was made with it. Only what differs is brought to the device, and its memory grows
 * where there is more; of a tracer that follows an editable volume (voxc_tracer_follow) all is brought, and
 * it follows no longer. `copied_bytes` says how much, unless it is null. Errors: a volume of another format,
 * which changes nothing; the device has no room or fails, after which the tracer can only be freed. */
VOXC_API voxc_error *voxc_tracer_update(voxc_tracer *tracer, const voxc_volume *volume,
                                        uint64_t *copied_bytes);

#ifdef __cplusplus
}
#endif

#endif
