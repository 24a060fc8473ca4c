#!/usr/bin/env bash
# sysroot.sh ARCHITECTURE FOLDER: the libraries that voxc is built with, for another processor: what scripts/packages.txt lists of them, from
# where this machine's packages come from, and all that they need.
#
# Nothing of them is run or installed here. FOLDER is what a cross compiler takes as its --sysroot, and qemu as its -L.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -eq 2 ] || { echo "usage: scripts/sysroot.sh ARCHITECTURE FOLDER" >&2; exit 1; }
architecture=$1 folder=$(realpath -m "$2")
state=$folder.apt

# Libraries, and what their CMake files ask for; no tools, no window and no components.
mapfile -t packages < <(
  grep -E '^(lib.*-dev|llvm-19-dev|clang-19|glslang-.*|spirv-.*|zlib1g-dev|nlohmann-json3-dev)$' scripts/packages.txt |
    grep -v -E 'clang-rt|glfw|imgui|assimp|vdb'
)
mkdir -p "$folder" "$state"/{lists/partial,archives/partial}
: > "$state/status"
options=(-o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o "Dir::State=$state"
  -o "Dir::State::status=$state/status" -o "Dir::Cache=$state" -o APT::Install-Recommends=false -o Acquire::Languages=none -qq)
apt-get "${options[@]}" update
apt-get "${options[@]}" --download-only --yes install "${packages[@]}" llvm-19-tools libstdc++-12-dev
for package in "$state"/archives/*.deb; do
  dpkg-deb --extract "$package" "$folder"
done
rm -rf "$state"
