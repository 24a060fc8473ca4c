// The functions of voxc_format_c.h, by those of voxc_format.h, whose text is C++ and GLSL.
#include "voxc_format_c.h"

// C has these names too, with other types behind them.
namespace voxc_format_cpp {
#include "voxc_format.h"
} // namespace voxc_format_cpp

namespace {

namespace text = voxc_format_cpp::voxc_format_text;

text::vec3 vector(const float *v) { return {v[0], v[1], v[2]}; }

void put(text::vec3 from, float *to) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

text::voxc_format_Hit taken(const voxc_format_Hit &hit) {
  return {{hit.voxel[0], hit.voxel[1], hit.voxel[2]}, hit.t, hit.colour, hit.axis, hit.side};
}

voxc_format_Hit told(const text::voxc_format_Hit &hit) {
  return {{hit.voxel.x, hit.voxel.y, hit.voxel.z}, hit.t, hit.colour, hit.axis, hit.side};
}

} // namespace

bool voxc_format_closest(const uint32_t *words, const float origin[3], const float direction[3], float tmin, float tmax,
                      voxc_format_Hit *hit) {
  text::voxc_format_Hit found;
  const bool hits = text::voxc_format_closest(words, vector(origin), vector(direction), tmin, tmax, found);
  *hit = told(found);
  return hits;
}

bool voxc_format_next(const uint32_t *words, const float origin[3], const float direction[3], float tmax, voxc_format_Hit *hit) {
  text::voxc_format_Hit found = taken(*hit);
  const bool hits = text::voxc_format_next(words, vector(origin), vector(direction), tmax, found);
  *hit = told(found);
  return hits;
}

bool voxc_format_any(const uint32_t *words, const float origin[3], const float direction[3], float tmin, float tmax) {
  return text::voxc_format_any(words, vector(origin), vector(direction), tmin, tmax);
}

void voxc_format_normal(const voxc_format_Hit *hit, float normal[3]) { put(text::voxc_format_normal(taken(*hit)), normal); }

void voxc_format_outside(const float origin[3], const float direction[3], const voxc_format_Hit *hit, float place[3]) {
  put(text::voxc_format_outside(vector(origin), vector(direction), taken(*hit)), place);
}
