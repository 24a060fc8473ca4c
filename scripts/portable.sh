#!/usr/bin/env bash
# Links voxc so that it runs elsewhere: on every system with glibc 2.28 or later, with all that Debian has of it within; what the wheel
# and the tarball hold. cmake/VoxcPortable.cmake says how.
#
# Usage: scripts/portable.sh [BUILD [PRESET]]
# BUILD (default: build/release) is built as far as is needed, by PRESET (default: release), and has the result in BUILD/portable. Of two
# libraries Debian has no archive that a shared library could hold; theirs are made of their sources, which come from where this machine's
# packages come from.
cd "$(dirname "$0")/.."
source scripts/lib.sh
build="$(realpath -m "${1:-build/release}")"
readonly build preset=${2:-release}
readonly made=$build/portable/made # Where cmake/portable/archives.py looks.

# What CMake found for a name, such as the compiler, which may be one for another processor. That for C compiles C++ too.
found() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

unpack() { # PACKAGE: its source, in a folder of its name.
  [ ! -d "$1" ] || return 0
  apt-get "${options[@]}" source "$1" > "$1.log"
  mv "$1"-[0-9]*/ "$1"
}

mesh_optimizer() {
  unpack meshoptimizer
  for file in meshoptimizer/src/*.cpp; do
    "${compiler[@]}" -O2 -fPIC -ffunction-sections -fdata-sections -c "$file" -o "meshoptimizer/$(basename "$file" .cpp).o"
  done
  "$(found CMAKE_AR)" rcs libmeshoptimizer.a meshoptimizer/*.o
}

turbo_jpeg() {
  unpack libjpeg-turbo
  local chosen=(-DCMAKE_BUILD_TYPE=Release -DENABLE_SHARED=OFF -DREQUIRE_SIMD=ON -DCMAKE_POSITION_INDEPENDENT_CODE=ON)
  [ -z "$sysroot" ] || chosen+=("-DCMAKE_TOOLCHAIN_FILE=$(found CMAKE_TOOLCHAIN_FILE)" "-DVOXC_SYSROOT=$sysroot")
  cmake -S libjpeg-turbo -B libjpeg-turbo/made -G Ninja "${chosen[@]}" > libjpeg-turbo.log
  cmake --build libjpeg-turbo/made --target turbojpeg-static
  cp libjpeg-turbo/made/libturbojpeg.a .
}

fetch_sysroot "$preset"
cmake --preset "$preset" -B "$build" > /dev/null
sysroot=$(found VOXC_SYSROOT)
IFS=';' read -r -a compiler <<< "$(found VOXC_PORTABLE_COMPILER)"
readonly sysroot compiler
if [ ! -e "$made/libmeshoptimizer.a" ] || [ ! -e "$made/libturbojpeg.a" ]; then
  mkdir -p "$made/lists/partial"
  apt-get indextargets --format '$(TARGET_OF) $(REPO_URI) $(RELEASE) $(COMPONENT)' |
    awk '$1 == "deb" && $3 ~ /^bookworm/ { print "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]", $2, $3, $4 }' |
    sort -u > "$made/sources.list"
  options=(-o "Dir::Etc::SourceList=$made/sources.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$made/lists"
    -o APT::Sandbox::User=root -qq)
  apt-get "${options[@]}" update
  (cd "$made" && mesh_optimizer && turbo_jpeg)
fi
cmake --build "$build" --target voxc-portable voxc-portable-program

rm -rf "$build"/portable/{bin,lib}
mkdir "$build"/portable/{bin,lib}
cp "$build/portable/voxc-portable-program" "$build/portable/bin/voxc"
cp "$build/portable/libvoxc-portable.so" "$build/portable/lib/libvoxc.so.0"
ln -s libvoxc.so.0 "$build/portable/lib/libvoxc.so"
# GLFW is loaded when a window opens. Debian's library asks for no newer system than voxc does, but for X11's.
cp -L "$("${compiler[@]}" -print-file-name=libglfw.so.3)" "$build/portable/lib/libglfw.so.3"
