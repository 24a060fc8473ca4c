#version 460
// A path for each pixel: what the eye sees, what bounces, and whether the sun and the lamp are seen, all through one include.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 0) readonly buffer Volume { uint words[]; };
layout(std430, binding = 1) buffer Picture { vec4 sums[]; };
layout(push_constant) uniform Frame {
  vec4 eye;
  vec4 right; // From the middle of the picture to its edges.
  vec4 up;
  vec4 forward;
  uint width, height;
  uint number; // Of this path in its pixel.
};

// There is one volume, so a volume is nothing that need be told.
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words[index]
#include "voxc_hall.h"
const uint HALL = 0u;

#define INFINITE uintBitsToFloat(0x7f800000u)
const float PI = 3.14159265;
const int BOUNCES = 6;

const vec3 SUN = normalize(vec3(0.55, 0.8, -0.28));
const float SUN_WIDTH = 0.02;
const vec3 SUN_LIGHT = vec3(9.0, 7.4, 5.4);
const vec3 LAMP = vec3(128.0, 48.0, 150.0);
const float LAMP_RADIUS = 9.0;
const float LAMP_POWER = 30.0;

// What is above says what a voxel is made of: Hall.h.
const uint SHINING = 254u;
const uint MIRROR = 253u;

uint random_state;

float random() { // PCG.
  random_state = random_state * 747796405u + 2891336453u;
  uint word = ((random_state >> ((random_state >> 28u) + 4u)) ^ random_state) * 277803737u;
  return float((word >> 22u ^ word) >> 8u) / 16777216.0;
}

vec3 random_on_sphere() {
  float z = 2.0 * random() - 1.0, angle = 2.0 * PI * random(), r = sqrt(max(1.0 - z * z, 0.0));
  return vec3(r * cos(angle), r * sin(angle), z);
}

vec3 sky(vec3 direction) {
  return mix(vec3(0.9, 0.8, 0.7), vec3(0.25, 0.5, 1.0), sqrt(max(direction.y, 0.0))) * 1.4;
}

vec3 colour_of(uint colour) { return pow(unpackUnorm4x8(colour).rgb, vec3(2.2)); }

// The light of the sun that comes to a point: a shadow ray without an end.
vec3 sunlight(vec3 point, vec3 normal) {
  vec3 direction = normalize(SUN + SUN_WIDTH * random_on_sphere());
  float cosine = dot(normal, direction);
  return cosine <= 0.0 || voxc_hall_any(HALL, point, direction, 0.0, INFINITE) ? vec3(0.0) : SUN_LIGHT * cosine / PI;
}

// That of the lamp: a shadow ray that ends before it.
vec3 lamplight(vec3 point, vec3 normal) {
  vec3 out_of_lamp = random_on_sphere();
  vec3 way = LAMP + (LAMP_RADIUS + 2.0) * out_of_lamp - point;
  float squared = dot(way, way);
  float cosines = max(dot(normal, way), 0.0) * max(-dot(out_of_lamp, way), 0.0) / squared;
  if (cosines <= 0.0 || voxc_hall_any(HALL, point, way, 0.0, 1.0))
    return vec3(0.0);
  return vec3(1.0, 0.45, 0.15) * LAMP_POWER * 4.0 * LAMP_RADIUS * LAMP_RADIUS * cosines / squared;
}

vec3 radiance(vec3 origin, vec3 direction) {
  vec3 light = vec3(0.0), weight = vec3(1.0);
  bool sees_lamps = true; // Else their light has been counted at the last bounce.
  for (int bounce = 0; bounce < BOUNCES; bounce++) {
    voxc_hall_Hit hit;
    if (!voxc_hall_closest(HALL, origin, direction, 0.0, INFINITE, hit))
      return light + weight * sky(direction);
    uint material = hit.colour >> 24;
    vec3 colour = colour_of(hit.colour);
    if (material == SHINING)
      return light + (sees_lamps ? weight * colour * LAMP_POWER : vec3(0.0));
    weight *= colour;
    vec3 normal = voxc_hall_normal(hit);
    vec3 point = voxc_hall_outside(origin, direction, hit);
    sees_lamps = material == MIRROR;
    if (sees_lamps) {
      direction = reflect(direction, normal);
    } else {
      light += weight * (sunlight(point, normal) + lamplight(point, normal));
      direction = normalize(normal + 0.999 * random_on_sphere());
    }
    origin = point;
  }
  return light;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height)
    return;
  uint at = pixel.y * width + pixel.x;
  random_state = (at * 9781u + number) * 26699u + 1u;
  random();
  vec2 place = (vec2(pixel) + vec2(random(), random())) / vec2(width, height) * 2.0 - 1.0;
  vec3 direction = normalize(forward.xyz + place.x * right.xyz - place.y * up.xyz);
  vec4 sum = number == 0u ? vec4(0.0) : sums[at];
  sums[at] = sum + vec4(min(radiance(eye.xyz, direction), vec3(20.0)), 1.0);
}
