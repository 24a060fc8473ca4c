// Kernels that ask the functions of a header, in GLSL and in HLSL; what is before the header, and what is
// behind.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

inline constexpr std::array<const char *, 2> kQueriesInGlsl = {R"(
layout(std430, set = 0, binding = 2) readonly buffer Words { uint words[]; };
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words[index]
)",
                                                               R"(
uint mixed(uint a, uint b) { return (a ^ b) * 0x01000193u; }
float number(uint at) { return uintBitsToFloat(ray_pairs[at / 2u][at & 1u]); }
void put(uint at, uint word) { hit_pairs[at / 2u][at & 1u] = word; }

void main() {
  if (task != ALL || gl_GlobalInvocationID.x >= ray_count || (first_ray + gl_GlobalInvocationID.x) % 2u != 0u)
    return;
  uint at = 6u * (first_ray + gl_GlobalInvocationID.x);
  vec3 origin = vec3(number(at), number(at + 1u), number(at + 2u));
  vec3 direction = vec3(number(at + 3u), number(at + 4u), number(at + 5u));
  float tmin = number(at + 6u), tmax = number(at + 7u);
  voxc_test_Hit hit;
  bool found = voxc_test_closest(0u, origin, direction, tmin, tmax, hit);
  put(at, uint(hit.voxel.x));
  put(at + 1u, uint(hit.voxel.y));
  put(at + 2u, uint(hit.voxel.z));
  put(at + 3u, hit.colour);
  put(at + 4u, floatBitsToUint(hit.t));
  put(at + 5u, uint(4 * hit.axis + hit.side));
  put(at + 6u, voxc_test_any(0u, origin, direction, tmin, tmax) ? 1u : 0u);
  uint count = 0u, all = 0u;
  for (; found; found = voxc_test_next(0u, origin, direction, tmax, hit)) {
    count++;
    all = mixed(mixed(all, uint(hit.voxel.x + 16 * hit.voxel.y + 256 * hit.voxel.z)), floatBitsToUint(hit.t));
  }
  put(at + 7u, count);
  put(at + 8u, all & 0x7fffffffu);
}
)"};

inline constexpr std::array<const char *, 2> kQueriesInHlsl = {R"(
[[vk::binding(0, 0)]] ByteAddressBuffer rays;
[[vk::binding(1, 0)]] RWByteAddressBuffer hits;
[[vk::binding(2, 0)]] ByteAddressBuffer words;
struct Tile { uint first_ray; uint ray_count; uint task; };
[[vk::push_constant]] ConstantBuffer<Tile> tile;
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words.Load(4u * (index))
)",
                                                               R"(
uint mixed(uint a, uint b) { return (a ^ b) * 0x01000193u; }
float number(uint at) { return asfloat(rays.Load(4u * at)); }
void put(uint at, uint word) { hits.Store(4u * at, word); }

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  if (tile.task != 0u || id.x >= tile.ray_count || (tile.first_ray + id.x) % 2u != 0u)
    return;
  uint at = 6u * (tile.first_ray + id.x);
  float3 origin = float3(number(at), number(at + 1u), number(at + 2u));
  float3 direction = float3(number(at + 3u), number(at + 4u), number(at + 5u));
  float tmin = number(at + 6u), tmax = number(at + 7u);
  voxc_test_Hit hit;
  bool found = voxc_test_closest(0u, origin, direction, tmin, tmax, hit);
  put(at, uint(hit.voxel.x));
  put(at + 1u, uint(hit.voxel.y));
  put(at + 2u, uint(hit.voxel.z));
  put(at + 3u, hit.colour);
  put(at + 4u, asuint(hit.t));
  put(at + 5u, uint(4 * hit.axis + hit.side));
  put(at + 6u, voxc_test_any(0u, origin, direction, tmin, tmax) ? 1u : 0u);
  uint count = 0u, all = 0u;
  while (found) {
    count++;
    all = mixed(mixed(all, uint(hit.voxel.x + 16 * hit.voxel.y + 256 * hit.voxel.z)), asuint(hit.t));
    found = voxc_test_next(0u, origin, direction, tmax, hit);
  }
  put(at + 7u, count);
  put(at + 8u, all & 0x7fffffffu);
}
)"};

namespace test {

/// SPIR-V of a compute shader in HLSL, by glslang. Failures are those of the test.
std::vector<std::uint32_t> compileHlsl(const std::string &text);

} // namespace test
} // namespace voxc
