#!/usr/bin/env bash
# Makes an AppImage of the tools, one file that runs on Linux with glibc 2.28 or later: the tree of the tarball as a squashfs behind a small
# program (scripts/portable/appimage.c), which unpacks it into the user's cache the first time.
#
# Usage: scripts/appimage.sh FOLDER
# FOLDER has the tarball of scripts/tarball.sh. Needs squashfs-tools and libsquashfuse-dev (scripts/packages-full.txt).
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -eq 1 ] || { echo "usage: scripts/appimage.sh FOLDER" >&2; exit 1; }
readonly folder=$1
tarball=$(ls "$folder"/voxc-*.tar.xz)
moment=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
name=$(basename "$tarball" .tar.xz)
readonly root=$work/$name

tar -C "$work" -xf "$tarball"
ln -s bin/voxc "$root/AppRun"
"$root/bin/voxc" run builtin:terrain --size 256x256 -o "$root/voxc.png" --device cpu --quiet
cat > "$root/voxc.desktop" << 'DESKTOP'
[Desktop Entry]
Type=Application
Name=voxc
Comment=Voxel volumes: build, trace and view them
Exec=voxc view %f
Icon=voxc
Terminal=true
Categories=Graphics;3DGraphics;
DESKTOP
for package in libsquashfuse-dev libc6-dev; do # Of which parts are in the program at the front.
  cp "/usr/share/doc/$package/copyright" "$root/licences/$package.txt"
done
scripts/portable/appimage-of.sh "$root" "$folder/$name.AppImage" "$moment"
printf '%s, %d bytes\n' "$folder/$name.AppImage" "$(stat -c %s "$folder/$name.AppImage")"
