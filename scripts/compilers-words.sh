#!/usr/bin/env bash
# compilers-words.sh: the words of the 520 golden volumes, and the voxelizer against the independent one, by voxc as other compilers build
# it, and for another processor, which qemu runs. The unit tests of the default build are one more opinion.
cd "$(dirname "$0")/.."
source scripts/lib.sh

readonly folder=build/compilers
readonly sysroot=$PWD/$folder/aarch64

# A build: its name, options of CMake, its flags, how long its tests are, and what runs its programs. By qemu the largest volumes would take
# too much memory, so that it has every third format.
builds=(
  "gxx-O0|-DCMAKE_CXX_COMPILER=g++|-O0|2|"
  "clang-O3|-DCMAKE_CXX_COMPILER=clang++-19|-O3 -DNDEBUG|2|"
  "aarch64|-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/aarch64.cmake -DVOXC_SYSROOT=$sysroot|-O3|1|qemu-aarch64 -L $sysroot"
)

[ -d "$sysroot" ] || scripts/sysroot.sh arm64 "$sysroot"
for row in "${builds[@]}"; do
  IFS='|' read -r name options flags length runner <<< "$row"
  build="$folder/words-$name"
  say "Building $name with $flags in $build"
  # shellcheck disable=SC2086 # Options are words.
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None $options -DCMAKE_CXX_FLAGS="$flags" -DVOXC_FIRST_BUILD=ON > /dev/null
  nice cmake --build "$build" --target voxc-test-Support voxc-test-Construct voxc-test-Mesh voxc-test-Oracle > "$build/build.log" ||
    { tail -30 "$build/build.log"; exit 1; }
  export VOXC_TEST_FACTOR=$length
  $runner "$build/bin/voxc-test-Support" --gtest_brief=1 --gtest_filter='Narrowing.*'
  $runner "$build/bin/voxc-test-Construct" --gtest_brief=1 --gtest_filter='Words.*'
  $runner "$build/bin/voxc-test-Mesh" --gtest_brief=1 --gtest_filter='MeshSource.*:MapCoordinates.*:*Models*'
  $runner "$build/bin/voxc-test-Oracle" --gtest_brief=1
done
