#!/usr/bin/env bash
# Runs examples/engine with a Mesa whose lavapipe has ray-tracing pipelines, that of Debian 13 (25.0), in a clean root of it, under
# the validation layer, and compares every answer with `voxc trace`.
#
# Usage: scripts/engine-chroot.sh FOLDER [BUILD]
# FOLDER gets the picture, the rays and the hits. BUILD (default: build/release) has been built. Needs root and debootstrap
# (scripts/packages-full.txt); packages come from where this machine's come from.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: scripts/engine-chroot.sh FOLDER [BUILD]" >&2; exit 1; }
readonly folder=$1 build=${2:-build/release}
readonly desk=/srv/check # In the root.
mirror="$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | awk '$2 == "bookworm" { print $1; exit }')"
work="$(mktemp -d -p "${TMPDIR:-/var/tmp}" engine.XXXXXX)"
root=$work/root
trap 'umount -q "$root/proc" || true; rm -rf --one-file-system "$work"' EXIT
mkdir -p "$folder"

cmake --install "$build" --prefix "$work/install" > "$work/log"
{
  cmake -S examples/engine -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/install"
  cmake --build "$work/build"
} >> "$work/log" || { tail -20 "$work/log"; exit 1; }
debootstrap --variant=minbase --include=mesa-vulkan-drivers,libvulkan1,vulkan-validationlayers,libzstd1,libpng16-16t64,libstdc++6 \
  trixie "$root" "$mirror" > "$work/log" || { tail "$work/log"; exit 1; }
mount -t proc proc "$root/proc" # Devices are those that debootstrap made: nothing of this machine's is in the root.

mkdir -p "$root$desk"
cp "$work/build/engine" "$root$desk"
PYTHONPATH=python VOXC_LIBRARY="$build/lib/libvoxc.so" VOXC="$build/bin/voxc" /usr/bin/python3 examples/engine/chunks.py \
  "$root$desk/chunks" > "$work/log"
chroot "$root" /usr/bin/env -i PATH=/usr/bin:/bin HOME="$desk" VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation \
  "$desk/engine" "$desk/chunks" "$desk/frame" 640 360 2>&1 | tee "$work/said"
if grep -q VUID "$work/said"; then
  exit 1
fi
"$build/bin/voxc" trace "$root$desk/chunks/whole.hvx" --rays "$root$desk/frame.rays" -o "$work/whole.hits" --device cpu --quiet
python3 test/Install/Inputs/engine/compare.py "$root$desk/frame" "$work/whole.hits"
cp "$root$desk"/frame.* "$folder"
