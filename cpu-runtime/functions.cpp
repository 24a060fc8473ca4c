// The functions of ${prefix}c.h, by those of ${prefix-}.h, whose text is C++ and GLSL.
#include "${prefix}c.h"

// C has these names too, with other types behind them.
namespace ${prefix}cpp {
#include "${prefix-}.h"
} // namespace ${prefix}cpp

namespace {

namespace text = ${prefix}cpp::${prefix}text;

text::vec3 vector(const float *v) { return {v[0], v[1], v[2]}; }

void put(text::vec3 from, float *to) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

text::${prefix}Hit taken(const ${prefix}Hit &hit) {
  return {{hit.voxel[0], hit.voxel[1], hit.voxel[2]}, hit.t, hit.colour, hit.axis, hit.side};
}

${prefix}Hit told(const text::${prefix}Hit &hit) {
  return {{hit.voxel.x, hit.voxel.y, hit.voxel.z}, hit.t, hit.colour, hit.axis, hit.side};
}

} // namespace

bool ${prefix}closest(const uint32_t *words, const float origin[3], const float direction[3], float tmin, float tmax,
                      ${prefix}Hit *hit) {
  text::${prefix}Hit found;
  const bool hits = text::${prefix}closest(words, vector(origin), vector(direction), tmin, tmax, found);
  *hit = told(found);
  return hits;
}

bool ${prefix}next(const uint32_t *words, const float origin[3], const float direction[3], float tmax, ${prefix}Hit *hit) {
  text::${prefix}Hit found = taken(*hit);
  const bool hits = text::${prefix}next(words, vector(origin), vector(direction), tmax, found);
  *hit = told(found);
  return hits;
}

bool ${prefix}any(const uint32_t *words, const float origin[3], const float direction[3], float tmin, float tmax) {
  return text::${prefix}any(words, vector(origin), vector(direction), tmin, tmax);
}

void ${prefix}normal(const ${prefix}Hit *hit, float normal[3]) { put(text::${prefix}normal(taken(*hit)), normal); }

void ${prefix}outside(const float origin[3], const float direction[3], const ${prefix}Hit *hit, float place[3]) {
  put(text::${prefix}outside(vector(origin), vector(direction), taken(*hit)), place);
}
