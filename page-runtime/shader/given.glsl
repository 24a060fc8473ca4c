// What a pass is given beside textures: a uniform of WebGL, a buffer of WebGPU.
struct Given {
  // The camera, in spaced space; places of the picture are from (-1, -1), its lower left corner, to (1, 1).
  vec3 eye;
  vec3 front;
  vec3 right; // From the picture's middle to its edges.
  vec3 up;
  int is_parallel; // Rays are parallel, and begin in the plane of the eye.
  // The pixels of a picture, and its light.
  ivec2 size;
  int is_smooth; // Surfaces have the direction of their neighbourhood.
  float samples; // That pixels have so far.
  // A sample more.
  int is_sketch;       // No light yet: only where surfaces are.
  int is_further;      // There are samples, or a sketch, before this one.
  int is_after_sketch; // Whose light does not count.
  vec2 place;          // Where in a pixel.
  vec2 numbers;        // For directions to the sky.
  vec3 sun;
  float open_scale;
  // What a screen shows.
  vec2 canvas;
  float exposure;
  // Pixels that wait for pages of a volume.
  int is_partial; // Those that do not wait have one sample more.
  int is_again;   // Only those that wait are traced, from the first whose turn it is to the one before the last.
  uvec2 turn;
  int number;
};

// What a pass leaves in a place of its targets.
struct Texels {
  uvec4 first;
  uvec4 second;
};
