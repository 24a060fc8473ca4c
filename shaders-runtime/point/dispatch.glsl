// One invocation a point, each answered at once: none is left for another dispatch.
void main() {
  uint number = gl_GlobalInvocationID.x;
  if (task == ALL && number < ray_count)
    answer(6u * (first_ray + number));
}
