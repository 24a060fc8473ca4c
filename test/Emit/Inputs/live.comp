#version 460
layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) buffer Numbers { uint numbers[]; };

// Six values are read before the first is used.
void main() {
  uint a = numbers[0], b = numbers[1], c = numbers[2], d = numbers[3], e = numbers[4], f = numbers[5];
  numbers[6] = a * b ^ (c - d) ^ (e / f) ^ (a + f);
}
