// One more sample of each pixel: a ray from the eye, and from what it meets one to the sun and one to the sky.
uniform highp usampler2D before; // The samples so far: light, and how many rays have hit; as bits.
uniform int samples;             // How many they are.
uniform ivec2 size;
uniform vec3 eye;
uniform vec3 front;
uniform vec3 right; // From the picture's middle to its edges.
uniform vec3 up;
uniform vec2 place;   // Where in a pixel.
uniform vec2 numbers; // For directions to the sky.
uniform vec3 sun;
uniform float open_scale;
out uvec4 after;

const int SUN = 1, SKY = 2, DONE = 3;

// In a square of four by four pixels all rays to the sky go elsewhere.
vec2 numbers_of(ivec2 pixel) {
  int x = pixel.x, y = pixel.y;
  int order = ((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1;
  return fract(numbers + float(order) * vec2(0.7548776662, 0.5698402910));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  pixel.y = size.y - 1 - pixel.y;
  vec2 at = (vec2(pixel) + place) / vec2(size) * 2.0 - 1.0;
  vec3 origin = eye;
  vec3 direction = normalize(front + right * at.x - up * at.y);
  vec4 light = vec4(0.0);
  vec3 colour, normal, start;
  for (int task = 0; task < DONE;) {
    voxc_scene_Hit hit;
    bool found = voxc_scene_closest(0, origin, direction, 0.0, uintBitsToFloat(0x7f800000u), hit);
    if (task == SKY) {
      light.rgb += colour * sky_light(normal) * (found ? PASSED_ON * hit.t / (hit.t + open_scale) : 1.0);
      task = DONE;
    } else if (task == SUN) {
      light.rgb += found ? vec3(0.0) : colour * SUN_LIGHT * dot(normal, sun);
      task = SKY;
    } else if (found) {
      light.a = 1.0;
      colour = colour_of_word(hit.colour);
      normal = hit.axis < 0 ? -direction : voxc_scene_normal(hit);
      start = voxc_scene_outside(origin, direction, hit);
      task = dot(normal, sun) > 0.0 ? SUN : SKY;
    } else {
      task = DONE;
    }
    origin = start;
    direction = task == SUN ? sun : sky_direction(normal, numbers_of(pixel));
  }
  if (samples > 0)
    light += uintBitsToFloat(texelFetch(before, ivec2(gl_FragCoord.xy), 0));
  after = floatBitsToUint(light);
}
