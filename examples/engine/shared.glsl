// What all shaders of the pipeline share: as in main.cpp and Scene.h.
const float CHUNK = 32.0;  // Voxels along each edge.
const float MARGIN = 0.03; // Boxes are that much larger, so that no rounding lets a ray slip between two.

struct Payload { // That of voxc's closest-hit shaders.
  vec3 normal;
  float t;
  ivec3 voxel;
  uint colour;
};

struct Ray { // voxc::Ray
  float origin[3];
  float direction[3];
};

struct Answer {
  ivec3 voxel; // Of the world; -1 where there is none.
  uint colour;
  vec3 normal;
  float t;
};

layout(std430, binding = 1) readonly buffer Rays { Ray rays[]; };
layout(std430, binding = 2) writeonly buffer Answers { Answer answers[]; };
layout(std430, binding = 3) writeonly buffer Wanted { uint wanted[]; }; // By the number of a chunk: 1 where a ray asked for it.
