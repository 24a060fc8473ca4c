// Uses a part of the runtime that needs no device.
#include <voxc/IR/Format.h>

#include <cstdio>

int main() {
  const voxc::Expected<voxc::Format> format = voxc::parseFormat("R(4,4,4)G(8)");
  if (!format)
    return 1;
  std::printf("%s\n", voxc::toString(*format).c_str());
}
