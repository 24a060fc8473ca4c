#version 460
// Counts the hits of a kernel that are not the exact ones, in any bit of voxel, colour or t, and keeps the number of one of them.
layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) readonly buffer Exact { uint exact[]; };
layout(std430, set = 0, binding = 1) readonly buffer Found { uint found[]; };
layout(std430, set = 0, binding = 2) buffer Verdict {
  uint hits; // Of the exact ones, those that are no misses.
  uint wrong;
  uint example;
};
layout(push_constant) uniform Range { uint count; };

void main() {
  uint number = gl_GlobalInvocationID.x;
  if (number >= count)
    return;
  bool same = true;
  for (uint word = 6u * number; word < 6u * number + 5u; word++)
    same = same && exact[word] == found[word];
  if (int(exact[6u * number]) >= 0)
    atomicAdd(hits, 1u);
  if (!same) {
    atomicAdd(wrong, 1u);
    example = number;
  }
}
