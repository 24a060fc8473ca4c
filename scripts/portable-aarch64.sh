#!/usr/bin/env bash
# Proves that the wheel for aarch64 is complete, on a machine that is none: in a root that has Python, NumPy and pip for that processor and
# nothing of ours, qemu has pip install it, and runs a few lines that make a volume and a picture, and the program. The bytes must be those that
# the wheel for this machine makes here.
#
# Usage: scripts/portable-aarch64.sh FOLDER
# FOLDER has both wheels (scripts/wheel.sh). Needs root, and Debian's package qemu-user-static.
cd "$(dirname "$0")/.."
source scripts/lib.sh
[ $# -eq 1 ] || fail "usage: scripts/portable-aarch64.sh FOLDER"
readonly folder=$1 desk=/srv/check
readonly packages=build/aarch64-python # Fetched once.
readonly lines='
import sys, voxc
volume = voxc.build("R(3, 3, 3) G(4)", "builtin:terrain")
picture = volume.render(640, 360, device="cpu")
voxc.save_picture(sys.argv[1] + "/lines.png", picture)
volume.save(sys.argv[1] + "/lines.hvx")
print(volume)'
work=$(mktemp -d -p "${TMPDIR:-/var/tmp}" aarch64.XXXXXX)
readonly work root=$work/root here=$work/here
trap '! mountpoint -q "$root/proc" || umount "$root/proc"; rm -rf --one-file-system "$work"' EXIT

# What a program under qemu starts would be one for this machine: nothing here starts any. The packages are unpacked, not installed, so that
# none of NumPy's libraries of linear algebra was chosen yet.
inside() {
  env -i HOME="$desk" LC_ALL=C.UTF-8 "$(command -v chroot)" "$root" /usr/bin/qemu-aarch64-static \
    -E LD_LIBRARY_PATH=/usr/lib/aarch64-linux-gnu/blas:/usr/lib/aarch64-linux-gnu/lapack "$@"
}

make_root() {
  [ -d "$packages" ] || scripts/sysroot.sh arm64 "$packages" python3-numpy python3-pip
  cp -a "$packages" "$root"
  cp "$(command -v qemu-aarch64-static)" "$root/usr/bin"
  mkdir -p "$root"/{dev,proc,tmp} "$root$desk" "$here"
  mknod -m 666 "$root/dev/null" c 1 3
  mknod -m 666 "$root/dev/urandom" c 1 9
  mount -t proc proc "$root/proc"
}

picture_of() { # FOLDER VOXC...
  "${@:2}" run 'D(4^3, 7) M(3^3)' builtin:terrain --size 640x360 --device cpu -o "$1/program.png" --quiet
}

run_here() {
  python3 -m zipfile -e "$folder"/voxc-*_"$(uname -m)".whl "$here/site"
  chmod +x "$here/site/voxc/bin/voxc" # Which zipfile forgets.
  env PYTHONPATH="$here/site" /usr/bin/python3 -c "$lines" "$here"
  picture_of "$here" "$here/site/voxc/bin/voxc"
}

run_there() {
  local site=/usr/local/lib/python3.11/dist-packages
  cp "$folder"/voxc-*_aarch64.whl "$root$desk"
  inside /usr/bin/python3.11 -m pip install --quiet --no-index --break-system-packages --root-user-action ignore \
    "$desk/$(basename "$folder"/voxc-*_aarch64.whl)"
  inside /usr/bin/python3.11 -c "$lines" "$desk"
  picture_of "$desk" inside "$site/voxc/bin/voxc"
}

make_root
say "The wheel for $(uname -m), here"
run_here
say "The wheel for aarch64, by qemu"
begin=$SECONDS
run_there
for file in lines.png lines.hvx program.png; do
  cmp "$here/$file" "$root$desk/$file"
  echo "$file: $(stat -c %s "$here/$file") bytes, the same"
done
echo "installed and run in $((SECONDS - begin)) s"
