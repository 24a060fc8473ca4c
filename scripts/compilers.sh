#!/usr/bin/env bash
# compilers.sh VOXC [RAYS]: what voxc computes depends on no compiler and on no processor.
#
# testing/Digests computes voxels of scenes, meshes and points, rays of cameras, RAYS hard rays (10^7) with their exact hits, and
# hits of a header's functions. It is built by g++ and Clang, with and without their optimisers, and by g++ for aarch64, which
# qemu runs: all must print the same digests. It holds those parts of the libraries that need no LLVM, so that another processor
# takes a cross compiler alone.
cd "$(dirname "$0")/.."
source scripts/lib.sh

[ $# -ge 1 ] || fail "usage: scripts/compilers.sh VOXC [RAYS]"
voxc=$1 rays=${2:-10000000}
export out="$PWD/build/compilers"
mkdir -p "$out"

# A way to build it: its name, the compiler with its flags, and what runs the program.
ways=(
  "g++ -O0|g++ -O0|"
  "g++ -O2|g++ -O2|"
  "g++ -O3|g++ -O3|"
  "g++ -O3 for x86-64-v3|g++ -O3 -march=x86-64-v3|"
  "Clang -O3|clang++-19 -O3|"
  "g++ -O3 for aarch64|aarch64-linux-gnu-g++ -O3|qemu-aarch64 -L /usr/aarch64-linux-gnu"
)

sources() {
  find lib/Support lib/Source lib/Oracle lib/Mesh/Obj lib/Mesh/Ply lib/Mesh/Stl lib/Mesh/Solid \
    lib/Mesh/Voxelize lib/Input/Points lib/Trace/Rays/Camera.cpp testing/HardRays testing/HardScenes.cpp testing/Digests -name '*.cpp' |
    grep -v -E "lib/Source/(Export/|ReduceColours)|lib/Support/Platform/Windows"
  ls lib/Mesh/*.cpp lib/Input/Openers/InputText.cpp lib/Input/Openers/Units.cpp | grep -v SceneLoader
}

# What is compiled in one go: a dozen files, those of a folder apart, as first builds do (cmake/VoxcFirstBuild.cmake).
batches() {
  local alone="testing/Digests|$(grep -v '^#' cmake/alone.txt | grep . | paste -s -d '|')" files dozens place
  sources | grep -E "^($alone)" | sed "s|^|$PWD/|"
  rm -f "$out"/together-*.cpp
  mapfile -t files < <(sources | grep -v -E "^($alone)" | sort)
  dozens=$(((${#files[@]} + 11) / 12))
  for place in "${!files[@]}"; do
    printf '#include "%s"\n' "$PWD/${files[place]}" >> "$out/together-$((place % dozens)).cpp"
  done
  ls "$out"/together-*.cpp
}

# compiled FOLDER SOURCE COMPILER...: as the build compiles it; functions for others as a user would, without flags that keep
# numbers as they are written.
compiled() {
  local folder=$1 source=$2 flags=(-ffp-contract=off)
  shift 2
  # As cmake/VoxcRounding.cmake finds out.
  [[ $1 == clang* ]] || flags+=(-fno-tree-slp-vectorize)
  [[ $source != */FunctionDigests.cpp ]] || flags=()
  "$@" "${flags[@]}" -std=c++20 -w -ffunction-sections -fdata-sections -I. -Iinclude -Ilib "-I$out" -c "$source" \
    -o "$folder/$(echo "${source#"$PWD/"}" | tr / -).o"
}
export -f compiled

# built FOLDER COMPILER...: what the program does not reach may lack a library, and is left out.
built() {
  local folder=$1
  shift
  rm -rf "$folder"
  mkdir -p "$folder"
  batches | nice xargs -P "$(nproc)" -I{} bash -euc 'compiled "$@"' - "$folder" {} "$@"
  "$@" "$folder"/*.o -Wl,--gc-sections -pthread -o "$folder/digests"
}

"$voxc" compile "R(5, 5, 5)" --emit=header --name digests -o "$out" > /dev/null 2>&1
first=
for way in "${ways[@]}"; do
  IFS='|' read -r name compiler runner <<< "$way"
  folder="$out/${name// /-}"
  begin=$SECONDS
  built "$folder" $compiler
  took=$((SECONDS - begin)) begin=$SECONDS
  nice $runner "$folder/digests" "$rays" > "$folder/digests.txt" || fail "the program that is built by $name fails"
  first=${first:-$folder/digests.txt}
  diff "$first" "$folder/digests.txt" || fail "what is built by $name computes something else"
  echo "$name: $(wc -l < "$folder/digests.txt") digests, the same; $took s to build, $((SECONDS - begin)) s to run"
done
