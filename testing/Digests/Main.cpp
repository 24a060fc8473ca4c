// digests RAYS: what voxc computes of inputs that are made of integers, a line each. scripts/compilers.sh
// builds it by several compilers and for several processors, and compares what it prints.
#include "testing/Digests/Digest.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

namespace voxc::test {

namespace {

Expected<void> addAll(std::uint64_t rays, std::vector<NamedDigest> &digests) {
  if (Expected<void> added = addVoxelDigests(digests); !added)
    return added;
  if (Expected<void> added = addCameraDigests(digests); !added)
    return added;
  if (Expected<void> added = addFunctionDigests(rays / 10, digests); !added)
    return added;
  return addRayDigests(rays, digests);
}

} // namespace

} // namespace voxc::test

int main(int count, char **arguments) {
  using namespace voxc;
  std::vector<test::NamedDigest> digests;
  const std::uint64_t rays = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 100000;
  const Expected<void> added = test::addAll(rays, digests);
  for (const test::NamedDigest &digest : digests)
    std::printf("%016" PRIx64 " %s\n", digest.value, digest.name.c_str());
  if (!added)
    std::fprintf(stderr, "digests: %s\n", added.error().message.c_str());
  return added ? 0 : 1;
}
