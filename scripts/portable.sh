#!/usr/bin/env bash
# Links voxc so that it runs elsewhere: on every system with glibc 2.28 or later, with all that Debian has of it within; what the wheel
# and the tarball hold. cmake/VoxcPortable.cmake says how.
#
# Usage: scripts/portable.sh [BUILD]
# BUILD (default: build/release) is built as far as is needed, and has the result in BUILD/portable. Of two libraries Debian has no archive
# that a shared library could hold; theirs are made of their sources, which come from where this machine's packages come from.
set -euo pipefail
cd "$(dirname "$0")/.."
build="$(realpath -m "${1:-build/release}")"
readonly build
readonly made=$build/portable/made # Where cmake/portable/archives.py looks.

unpack() { # PACKAGE: its source, in a folder of its name.
  [ ! -d "$1" ] || return 0
  apt-get "${options[@]}" source "$1" > "$1.log"
  mv "$1"-[0-9]*/ "$1"
}

mesh_optimizer() {
  unpack meshoptimizer
  for file in meshoptimizer/src/*.cpp; do
    c++ -O2 -fPIC -ffunction-sections -fdata-sections -c "$file" -o "meshoptimizer/$(basename "$file" .cpp).o"
  done
  ar rcs libmeshoptimizer.a meshoptimizer/*.o
}

turbo_jpeg() {
  unpack libjpeg-turbo
  cmake -S libjpeg-turbo -B libjpeg-turbo/made -G Ninja -DCMAKE_BUILD_TYPE=Release -DENABLE_SHARED=OFF -DREQUIRE_SIMD=ON \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON > libjpeg-turbo.log
  cmake --build libjpeg-turbo/made --target turbojpeg-static
  cp libjpeg-turbo/made/libturbojpeg.a .
}

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
cmake --preset release -B "$build" > /dev/null
cmake --build "$build" --target voxc-portable voxc-portable-program

rm -rf "$build"/portable/{bin,lib}
mkdir "$build"/portable/{bin,lib}
cp "$build/portable/voxc-portable-program" "$build/portable/bin/voxc"
cp "$build/portable/libvoxc-portable.so" "$build/portable/lib/libvoxc.so.0"
ln -s libvoxc.so.0 "$build/portable/lib/libvoxc.so"
# GLFW is loaded when a window opens. Debian's library asks for no newer system than voxc does, but for X11's.
cp -L "$(cc -print-file-name=libglfw.so.3)" "$build/portable/lib/libglfw.so.3"
