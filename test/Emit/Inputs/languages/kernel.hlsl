ByteAddressBuffer words : register(t0);
RWStructuredBuffer<float> times : register(u1);
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words.Load(4u * (index))
#include "voxc_t.hlsl"

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  voxc_t_Hit hit;
  const bool found = voxc_t_closest(0u, float3(id), float3(1.0f, 0.5f, 0.25f), 0.0f, 1e30f, hit);
  times[id.x] = found ? hit.t : float(-voxc_t_VOLUME_SIZE.x);
}
