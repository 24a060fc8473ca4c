#!/usr/bin/env bash
# Builds the runtime for Windows by MinGW-w64, runs its tests by Wine, and compares what it converts, traces and verifies with this
# machine's program, byte for byte. docs/windows.md says what that shows.
#
# Usage: scripts/windows.sh [VOXC]
# VOXC (default: build/release/bin/voxc) is the program to compare with. All that is made is in build/windows. Libraries of which Debian
# has no archive for MinGW are made of their sources, which come from where this machine's packages come from, in a minute and a half.
# On two cores that others used too, all of it took 31 minutes, of which tests took 1:09 and the comparison a minute.
set -euo pipefail
cd "$(dirname "$0")/.."
voxc="$(realpath "${1:-build/release/bin/voxc}")"
readonly voxc
readonly build=$PWD/build/windows
readonly root=$build/root # Headers and libraries.
readonly toolchain=(-G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw.cmake" "-DVOXC_WINDOWS_ROOT=$root")
export WINEPREFIX=$build/wine WINEDEBUG=-all

# Libraries that are headers alone; all of /usr/include would bring this machine's C library along.
headers() {
  mkdir -p "$root/include"
  for header in boost CLI glm nlohmann vk_video vulkan xxhash.h; do
    ln -sfn "/usr/include/$header" "$root/include/$header"
  done
}

# library SOURCES OPTION...: builds what CMake knows how to build, and installs it in the root.
library() {
  local sources=$1 made
  made=$build/made/$(basename "${sources%/build/cmake}")
  shift
  cmake -S "$sources" -B "$made" "${toolchain[@]}" "-DCMAKE_INSTALL_PREFIX=$root" "$@" > "$made.log" 2>&1
  cmake --build "$made" --target install >> "$made.log" 2>&1
}

sources() { # PACKAGE...: in folders of their names and versions.
  mkdir -p "$build/sources/lists/partial"
  cd "$build/sources"
  apt-get indextargets --format '$(TARGET_OF) $(REPO_URI) $(RELEASE) $(COMPONENT)' |
    awk '$1 == "deb" && $3 == "bookworm" { print "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]", $2, $3, $4 }' |
    sort -u > sources.list
  local options=(-o "Dir::Etc::SourceList=$PWD/sources.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$PWD/lists"
    -o APT::Sandbox::User=root -qq)
  apt-get "${options[@]}" update
  apt-get "${options[@]}" source "$@" > log 2>&1
}

libraries() {
  mkdir -p "$build/made"
  headers
  (sources libzstd libpng1.6)
  library "$(echo "$build"/sources/libzstd-*/build/cmake)" -DZSTD_BUILD_PROGRAMS=OFF -DZSTD_BUILD_SHARED=OFF -DZSTD_BUILD_TESTS=OFF
  library "$(echo "$build"/sources/libpng1.6-*/)" -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
  library /usr/src/googletest
  touch "$root/complete"
}

# windows ARGUMENT...: the program, by Wine.
windows() { /usr/lib/wine/wine64 "$build/voxc/bin/voxc-volume.exe" "$@"; }

# same FILE: what both systems have written.
same() {
  cmp "linux/$1" "windows/$1"
  echo "$1: the same $(stat -c %s "linux/$1") bytes"
}

kernel() { # FORMAT: its kernel as a library, as docs/windows.md has it.
  "$voxc" compile "$1" --emit=cpu --system windows -o kernel --quiet
  printf '#include "intersect.h"\nconst uint64_t voxc_intersect_storage = VOXC_INTERSECT_STORAGE_DIGEST;\n' > kernel/storage.c
  x86_64-w64-mingw32-gcc-posix -O2 -shared kernel/intersect.o kernel/storage.c -o kernel.dll
}

conversions() {
  for ending in vox ply raw vti nvdb glb hvx; do
    "$voxc" export terrain.hvx -o "linux/terrain.$ending" --quiet
    windows convert terrain.hvx "windows/terrain.$ending" > told
    same "terrain.$ending"
  done
  windows convert terrain.hvx windows/größe-日本.ply > told
  cmp linux/terrain.ply windows/größe-日本.ply
}

hits() {
  windows rays terrain.hvx 100000 rays.bin
  "$voxc" trace terrain.hvx --rays rays.bin -o linux/hits.bin --device cpu --quiet
  windows trace terrain.hvx kernel.dll rays.bin windows/hits.bin
  same hits.bin
  windows verify terrain.hvx kernel.dll rays.bin
}

# What is wrong is told by the exit codes of Linux, and takes no file away that was there.
refusals() {
  cp windows/terrain.ply kept.ply
  head -c 1000 terrain.hvx > short.hvx
  for wrong in "1 short.hvx kept.ply" "1 none.hvx kept.ply" "1 terrain.hvx kept.dwg" "3 terrain.hvx none/kept.ply"; do
    read -r code volume output <<< "$wrong"
    local got=0
    windows convert "$volume" "$output" 2> told || got=$?
    [ "$got" = "$code" ] || { echo "$0: converting $volume to $output gave $got, not $code: $(cat told)" >&2; exit 1; }
  done
  cmp windows/terrain.ply kept.ply
  [ "$(find . -name '*.ply.*' | wc -l)" = 0 ] || { echo "$0: a temporary file was left behind" >&2; exit 1; }
}

[ -e "$root/complete" ] || libraries
cmake -S . -B "$build/voxc" "${toolchain[@]}" -DVOXC_RUNTIME_ONLY=ON -DVOXC_WERROR=ON > "$build/configured.log"
grep 'leaves out' "$build/configured.log" || true
cmake --build "$build/voxc"
ctest --test-dir "$build/voxc" --output-on-failure -j "$(nproc)"

rm -rf "$build/compared"
mkdir -p "$build/compared"/{linux,windows}
cd "$build/compared"
"$voxc" build 'D(5^3,15) M(2^3)' builtin:terrain -o terrain.hvx --quiet
kernel 'D(5^3,15) M(2^3)'
conversions
hits
refusals
echo "what is wrong is told, and takes no file away"
