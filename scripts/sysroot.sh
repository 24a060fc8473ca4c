#!/usr/bin/env bash
# sysroot.sh ARCHITECTURE FOLDER [PACKAGE...]: packages for another processor, from where this machine's come from, with all that they need;
# without names, the libraries that voxc is built with and those that its wheel is linked with, as far as scripts/packages.txt and
# scripts/packages-full.txt list them.
#
# Nothing of them is run or installed here. FOLDER is what a cross compiler takes as its --sysroot, and qemu as its -L. Its database of packages
# has what is in it: `dpkg-query --admindir FOLDER/var/lib/dpkg` answers (scripts/portable/contents.py asks).
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 2 ] || { echo "usage: scripts/sysroot.sh ARCHITECTURE FOLDER [PACKAGE...]" >&2; exit 1; }
architecture=$1 folder=$(realpath -m "$2")
shift 2
readonly state=$folder.apt made=$folder.made # A folder of its name is whole.

# Libraries, and what their CMake files ask for; no tools and no components.
libraries() {
  grep -E '^(lib.*-dev|llvm-19-dev|clang-19|glslang-.*|spirv-.*|zlib1g-dev|nlohmann-json3-dev)$' \
    scripts/packages.txt scripts/packages-full.txt --no-filename |
    grep -v -E 'clang-rt|squashfuse|assimp|vdb'
  echo llvm-19-tools
  echo libstdc++-12-dev
}

# What dpkg would write down of a package, had it installed it.
record() { # PACKAGE
  local name info=$made/var/lib/dpkg/info
  name=$(dpkg-deb --field "$1" Package)
  { echo "Status: install ok installed" && dpkg-deb --field "$1" && echo; } >> "$made/var/lib/dpkg/status"
  dpkg-deb --fsys-tarfile "$1" | tar -t | sed -e 's,^[.],,' -e 's,/$,,' > "$info/$name.list"
}

packages=("$@")
[ $# -gt 0 ] || mapfile -t packages < <(libraries)
rm -rf "$state" "$made" "$folder"
mkdir -p "$made/var/lib/dpkg/info" "$state"/{lists/partial,archives/partial}
: > "$state/status"
options=(-o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o "Dir::State=$state"
  -o "Dir::State::status=$state/status" -o "Dir::Cache=$state" -o APT::Install-Recommends=false -o Acquire::Languages=none -qq)
apt-get "${options[@]}" update
apt-get "${options[@]}" --download-only --yes install "${packages[@]}"
for package in "$state"/archives/*.deb; do
  dpkg-deb --extract "$package" "$made"
  record "$package"
done
rm -rf "$state"
mv "$made" "$folder"
