#!/usr/bin/env bash
# compilers-words.sh [BUILD...]: the words of the 520 golden volumes, and the voxelizer against the independent one, by voxc as other compilers
# build it, and for another processor, which qemu runs. The unit tests of the default build are one more opinion. BUILD is one of gxx-O0,
# clang-O3 and aarch64; without any, all are built and run.
cd "$(dirname "$0")/.."
source scripts/lib.sh

readonly folder=build/compilers
readonly tests=(voxc-test-{Support,Construct,Mesh,Oracle})

# A build: its name, options of CMake, its flags, what runs its programs, and in how many processes the words are compared, one after the other.
# qemu keeps what it has translated of each kernel, and would need too much memory for all of them in one.
builds=(
  "gxx-O0|-DCMAKE_CXX_COMPILER=g++|-O0||1"
  "clang-O3|-DCMAKE_CXX_COMPILER=clang++-19|-O3 -DNDEBUG||1"
  "aarch64||-O3 -DNDEBUG|qemu-aarch64 -L build/aarch64-sysroot|12"
)

# Builds the tests; sets `build`, the folder that has them. That for aarch64 is its preset's, which scripts/aarch64.sh builds too.
build_tests() { # NAME OPTIONS FLAGS
  build="$folder/words-$1"
  [ "$1" != aarch64 ] || build=build/aarch64
  say "Building $1 with $3 in $build"
  mkdir -p "$folder"
  local log=$folder/$1.log
  if [ "$1" = aarch64 ]; then
    build aarch64 "${tests[@]}" > "$log"
  else
    # shellcheck disable=SC2086 # Options are words.
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None $2 -DCMAKE_CXX_FLAGS="$3" -DVOXC_FIRST_BUILD=ON > /dev/null &&
      nice cmake --build "$build" --target "${tests[@]}" > "$log"
  fi || { tail -30 "$log"; exit 1; }
}

# Compares the words in so many processes, and fails if not all volumes of the list were compared.
compare_words() {
  local test=$1 runner=$2 parts=$3 part said compared=0 listed
  listed=$(grep -c -v '^#' unittests/Construct/Golden/words.txt)
  for ((part = 0; part < parts; ++part)); do
    said=$(VOXC_WORDS_PART=$part/$parts $runner "$test" --gtest_brief=1 --gtest_filter='Words.*') || { printf '%s\n' "$said"; exit 1; }
    compared=$((compared + $(sed -n 's/^\([0-9]*\) volumes of part.*/\1/p' <<< "$said")))
    say "$compared of $listed volumes have the words of the list"
  done
  [ "$compared" -eq "$listed" ] || fail "$compared volumes were compared, but the list has $listed"
}

wanted=("$@")
for row in "${builds[@]}"; do
  IFS='|' read -r name options flags runner parts <<< "$row"
  [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " = *" $name "* ]] || continue
  build_tests "$name" "$options" "$flags"
  export VOXC_TEST_FACTOR=2
  $runner "$build/bin/voxc-test-Support" --gtest_brief=1 --gtest_filter='Narrowing.*'
  compare_words "$build/bin/voxc-test-Construct" "$runner" "$parts"
  # What the independent voxelizer and the oracle say at twice their length takes hours by qemu.
  [ -z "$runner" ] || export VOXC_TEST_FACTOR=1
  $runner "$build/bin/voxc-test-Mesh" --gtest_brief=1 --gtest_filter='MeshSource.*:MapCoordinates.*:*Models*'
  $runner "$build/bin/voxc-test-Oracle" --gtest_brief=1
done
