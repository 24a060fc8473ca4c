#!/usr/bin/env bash
# Makes an AppImage of any tree that has an AppRun.
#
# Usage: scripts/portable/appimage-of.sh TREE FILE TIME
# All files are of TIME, in seconds of 1970: the same tree makes the same bytes.
set -euo pipefail
tree=$1 file=$2 moment=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
env -u SOURCE_DATE_EPOCH mksquashfs "$tree" "$work/tree" -comp zstd -all-root -no-xattrs -all-time "$moment" -mkfs-time "$moment" -quiet -no-progress > /dev/null
cc -O2 -static -s -Wall -Wextra -Werror "$(dirname "$0")/appimage.c" -o "$work/front" \
  -DDIGEST="\"$(sha256sum < "$work/tree" | head -c 16)\"" -lsquashfuse -lzstd
# What tells an AppImage of the second kind from other programs: three bytes where the head of the program has room.
printf 'AI\002' | dd of="$work/front" bs=1 seek=8 conv=notrunc status=none
cat "$work/front" "$work/tree" > "$file"
chmod +x "$file"
