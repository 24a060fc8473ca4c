#!/usr/bin/env bash
# compilers-words.sh: the words of the 520 golden volumes, and the voxelizer against the independent one, by voxc as other compilers
# build it. The unit tests of the usual build are the third opinion.
cd "$(dirname "$0")/.."
source scripts/lib.sh

# A build by another compiler: its folder, the compiler, its flags.
builds=(
  "gxx-O0|g++|-O0"
  "clang-O3|clang++-19|-O3 -DNDEBUG"
)

export VOXC_TEST_FACTOR=2
for row in "${builds[@]}"; do
  IFS='|' read -r name compiler flags <<< "$row"
  folder="build/compilers/words-$name"
  say "Building by $compiler $flags in $folder"
  cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" -DVOXC_FIRST_BUILD=ON \
    > /dev/null
  nice cmake --build "$folder" --target voxc-test-Support voxc-test-Construct voxc-test-Mesh voxc-test-Oracle > "$folder/build.log" ||
    { tail -30 "$folder/build.log"; exit 1; }
  "$folder/bin/voxc-test-Support" --gtest_brief=1 --gtest_filter='Narrowing.*'
  "$folder/bin/voxc-test-Construct" --gtest_brief=1 --gtest_filter='Words.*'
  "$folder/bin/voxc-test-Mesh" --gtest_brief=1 --gtest_filter='MeshSource.*:MapCoordinates.*:*Models*'
  "$folder/bin/voxc-test-Oracle" --gtest_brief=1
done
