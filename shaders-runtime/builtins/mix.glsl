// The choices of GLSL, component by component, that GLSL ES and HLSL lack.

vec3 mix(vec3 a, vec3 b, bvec3 takes_b) { return vec3(takes_b.x ? b.x : a.x, takes_b.y ? b.y : a.y, takes_b.z ? b.z : a.z); }

ivec3 mix(ivec3 a, ivec3 b, bvec3 takes_b) { return ivec3(takes_b.x ? b.x : a.x, takes_b.y ? b.y : a.y, takes_b.z ? b.z : a.z); }
