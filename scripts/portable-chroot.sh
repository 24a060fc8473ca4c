#!/usr/bin/env bash
# Proves that the wheel, the tarball and the AppImage are complete: in clean roots of systems, each of which has Python, NumPy and nothing of
# ours, the tarball is unpacked and its program runs, and the AppImage runs as it is; one command installs the wheel in a virtual environment, where five lines make a picture, the program
# runs, and the tests of the module pass.
#
# Usage: scripts/portable-chroot.sh FOLDER [SUITE[=MIRROR]...]
# FOLDER has what scripts/wheel.sh, scripts/tarball.sh and scripts/appimage.sh made, and gets a picture of each suite. The suites are Debian's or Ubuntu's, by default the
# oldest and the newest Debian that packages are to be had of (bullseye, with glibc 2.31, and trixie, with 2.41); a mirror is where its packages
# come from, by default from where this machine's do. Where Python is older than 3.9, the tarball alone is tried. Needs root and debootstrap
# (scripts/packages-full.txt).
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: scripts/portable-chroot.sh FOLDER [SUITE[=MIRROR]...]" >&2; exit 1; }
readonly folder=$1
shift
[ $# -gt 0 ] || set -- bullseye trixie
readonly desk=/srv/check # In the root.
mirror="$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | awk '$2 == "bookworm" { print $1; exit }')"
work="$(mktemp -d -p "${TMPDIR:-/var/tmp}" portable.XXXXXX)"
root=
trap '[ -z "$root" ] || umount -q "$root/proc" || true; rm -rf --one-file-system "$work"' EXIT

inside() { chroot "$root" /usr/bin/env -i PATH="$desk/venv/bin:/usr/bin:/bin" HOME="$desk" LC_ALL=C.UTF-8 "$@"; }

make_root() { # SUITE MIRROR
  local options=(--variant=minbase --include=python3-venv,python3-numpy)
  case $2 in
  # Ubuntu's suites are all made alike, and Debian has no key of theirs.
  */ubuntu*) options+=(--components=main,universe --no-check-gpg) && set -- "$1" "$2" /usr/share/debootstrap/scripts/gutsy ;;
  esac
  debootstrap "${options[@]}" "$1" "$root" "${@:2}" > "$work/log" || { tail "$work/log"; exit 1; }
  mount -t proc proc "$root/proc" # Devices are those that debootstrap made: nothing of this machine's is in the root.
}

is_picture() { [ "$(head -c 4 "$root$1" | tail -c 3)" = PNG ]; }

try_tarball() {
  tar -C "$root$desk" -xf "$(ls "$folder"/voxc-*.tar.xz)"
  local voxc
  voxc=$(cd "$root" && ls -d ."$desk"/voxc-*/bin/voxc)
  inside "/$voxc" run 'R(3, 3, 3) G(4)' builtin:terrain --size 640x360 -o "$desk/tarball.png" --quiet
  is_picture "$desk/tarball.png"
  inside sh -c 'ldd --version | head -n 1'
  echo "the tarball: $(inside "/$voxc" --version), $(inside "/$voxc" devices | grep -c '^[a-z0-9]') device"
}

try_appimage() {
  cp "$folder"/voxc-*.AppImage "$root$desk/voxc.AppImage"
  local begin=$SECONDS
  inside "$desk/voxc.AppImage" run 'R(3, 3, 3) G(4)' builtin:terrain --size 640x360 -o "$desk/appimage.png" --quiet
  cmp "$root$desk/appimage.png" "$root$desk/tarball.png"
  printf 'the AppImage: the picture of the tarball, in %d s' $((SECONDS - begin))
  begin=$SECONDS
  inside "$desk/voxc.AppImage" --version > /dev/null
  printf ', and started again in %d s\n' $((SECONDS - begin))
}

try_wheel() { # SUITE
  cp "$folder"/voxc-*_"$(uname -m)".whl python/voxc*_test.py "$root$desk"
  inside python3 -m venv --system-site-packages "$desk/venv"
  local begin=$SECONDS
  inside pip install --quiet --disable-pip-version-check --no-index "$desk/$(basename "$folder"/voxc-*_"$(uname -m)".whl)"
  printf 'the wheel: installed in %d s; ' $((SECONDS - begin))
  inside python3 -c '
import voxc
volume = voxc.build("R(3, 3, 3) G(4)", "builtin:terrain")
picture = volume.render(640, 360)
voxc.save_picture("'"$desk"'/picture.png", picture)
print(volume)'
  inside voxc run 'R(3, 3, 3) G(4)' builtin:terrain --size 640x360 -o "$desk/program.png" --quiet
  (cd "$root$desk" && inside sh -c "cd $desk && python3 -m unittest -q ${tests[*]}") 2>&1 | tail -4
  cp "$root$desk/picture.png" "$folder/$1.png"
  is_picture "$desk/program.png"
  inside python3 -c 'import sys, numpy; print("Python", sys.version.split()[0], "NumPy", numpy.__version__)'
}

tests=()
for file in python/voxc*_test.py; do
  tests+=("$(basename "$file" .py)")
done
for suite; do
  root=$work/${suite%%=*}
  printf '\n== %s\n' "${suite%%=*}"
  case $suite in
  *=*) make_root "${suite%%=*}" "${suite#*=}" ;;
  *) make_root "$suite" "$mirror" ;;
  esac
  mkdir -p "$root$desk"
  try_tarball
  try_appimage
  if inside python3 -c 'import sys; sys.exit(sys.version_info < (3, 9))'; then
    try_wheel "${suite%%=*}"
  fi
  umount "$root/proc"
  rm -rf --one-file-system "$root"
  root=
done
