// The camera, in spaced space; places of the picture are from (-1, -1), its lower left corner, to (1, 1).
uniform vec3 eye;
uniform vec3 front;
uniform vec3 right; // From the picture's middle to its edges.
uniform vec3 up;
uniform bool is_parallel; // Rays are parallel, and begin in the plane of the eye.

// Where the ray through a place begins, from the eye.
vec3 aside(vec2 place) { return is_parallel ? right * place.x + up * place.y : vec3(0.0); }

vec3 way(vec2 place) { return normalize(is_parallel ? front : front + right * place.x + up * place.y); }
