// Takes what `voxc info` prints, and says whether the functions of two headers may read the words of that volume.
#include "voxc_deep.h"
#include "voxc_wide.h"

#include <cstdio>

int main() {
  unsigned long long volume = 0;
  for (char line[256]; std::fgets(line, sizeof line, stdin);)
    std::sscanf(line, "digest %llx", &volume);
  std::printf("%s: %s\n", VOXC_DEEP_FORMAT, volume == VOXC_DEEP_STORAGE_DIGEST ? "accepted" : "refused");
  std::printf("%s: %s\n", VOXC_WIDE_FORMAT, volume == VOXC_WIDE_STORAGE_DIGEST ? "accepted" : "refused");
}
