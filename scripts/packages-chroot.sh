#!/usr/bin/env bash
# Makes the Debian packages of a build and proves that they are complete: they are installed in a clean Debian 12 root, where every
# example is built and run, Python makes a picture in five lines, the manual opens and bash completes.
#
# Usage: scripts/packages-chroot.sh [BUILD]
# BUILD (default: build/release) has been built. Needs root and debootstrap (scripts/packages-full.txt); packages come from where
# this machine's come from. All lies in a folder that is removed at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
readonly build="${1:-build/release}"
readonly desk=/srv/check # In the root: where tools and programs write.
root="$(mktemp -d -p "${TMPDIR:-/var/tmp}" chroot.XXXXXX)"
trap 'umount -q "$root/proc" || true; rm -rf --one-file-system "$root"' EXIT

say() { printf '\n== %s\n' "$*"; }
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME="$desk" DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
install() { inside apt-get -qq install --no-install-recommends --yes "$@" > "$root/log" 2>&1 || { tail -20 "$root/log"; exit 1; }; }

# What an example is given, to end soon.
arguments() {
  case $1 in
  path-tracer) echo picture.png 64 36 4 ;;
  host-device) echo picture.png 64 36 ;;
  instances) echo "$desk/terrain.hvx" cpu 100 ;;
  engine) echo --help ;; # No device of Debian 12's has its pipelines: scripts/engine-chroot.sh.
  esac
}

say "Packages"
rm -f "$build"/*.deb
(cd "$build" && cpack -G DEB > cpack.log) || { tail "$build/cpack.log"; exit 1; }
dpkg-deb --show --showformat '${Package} ${Version}: ${Installed-Size} kB; ${Depends}\n' "$build"/voxc_*.deb

say "A clean root"
mirror="$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | awk '$2 == "bookworm" { print $1; exit }')"
debootstrap --variant=minbase bookworm "$root" "$mirror" > /dev/null
for configuration in apt.conf.d sources.list sources.list.d trusted.gpg trusted.gpg.d; do
  rm -rf "$root/etc/apt/$configuration"
  [ ! -e "/etc/apt/$configuration" ] || cp -rT "/etc/apt/$configuration" "$root/etc/apt/$configuration"
done
mount -t proc proc "$root/proc"
inside apt-get -qq update

say "The tools alone"
mkdir -p "$root/debs" "$root$desk"
cp "$build"/*.deb "$root/debs"
install $(cd "$root" && ls ./debs/voxc_*.deb) man-db bash-completion
inside voxc run 'R(3, 3, 3) G(4)' builtin:terrain -o "$desk/terrain.png" --device cpu
file_type() { head -c 4 "$1" | tail -c 3; }
[ "$(file_type "$root$desk/terrain.png")" = PNG ]
inside sh -c 'man voxc-build | head -4'
inside bash -c 'source /usr/share/bash-completion/bash_completion; COMP_WORDS=(voxc ren); COMP_CWORD=1
  _completion_loader voxc || true; _voxc; [ "${COMPREPLY[*]}" = render ] && echo "voxc ren: ${COMPREPLY[*]}"'

say "Python"
install $(cd "$root" && ls ./debs/libvoxc0_*.deb ./debs/python3-voxc_*.deb)
inside python3 -c '
import sys, voxc
volume = voxc.build("R(3, 3, 3) G(3)", "builtin:terrain")
picture = volume.render(320, 200, device="cpu")
voxc.save_picture(sys.argv[1], picture)
print(volume, picture.shape)' "$desk/python.png"
[ "$(file_type "$root$desk/python.png")" = PNG ]

say "Examples"
install $(cd "$root" && ls ./debs/libvoxc-dev_*.deb) gcc g++ cmake ninja-build mesa-vulkan-drivers \
  $(dpkg-deb --field "$build"/libvoxc-dev_*.deb Recommends | tr -d ,)
inside voxc build 'R(3, 3, 3) G(3)' builtin:terrain -o "$desk/terrain.hvx" --quiet
for example in "$root"/usr/share/doc/voxc/examples/*; do
  name="$(basename "$example")"
  made="$desk/$name"
  inside cmake -S "/usr/share/doc/voxc/examples/$name" -B "$made" -G Ninja -DCMAKE_BUILD_TYPE=Release > "$root/log" &&
    inside cmake --build "$made" >> "$root/log" || { tail -20 "$root/log"; exit 1; }
  program="$(find "$root$made" -maxdepth 1 -type f -executable -printf '%f\n')"
  echo "$name:"
  inside sh -c "cd $made && ./$program $(arguments "$name")"
done

say "All packages work"
