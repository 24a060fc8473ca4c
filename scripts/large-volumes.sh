#!/usr/bin/env bash
# Builds two volumes of more than 2^32 words, 21 GiB of references past them and one grid of 32 GiB, and traces both on the
# cpu; the hits must be those of a small volume of the same voxels, which the exact oracle confirms. The words are mostly 0,
# and holes in the files. With a Vulkan device as the second argument, which must have room for 21 GiB, it traces there too.
#
# Usage: scripts/large-volumes.sh BUILD [DEVICE]
# Takes about 15 minutes, 40 GiB of room in $TMPDIR or /var/tmp for a while, half a GiB at the end of each build, and no more
# memory than there is.
set -euo pipefail

readonly voxc="${1:?usage: scripts/large-volumes.sh BUILD [DEVICE]}/bin/voxc"
readonly device="${2:-}"
folder="$(mktemp -d -p "${TMPDIR:-/var/tmp}")"
readonly folder
trap 'rm -rf "$folder"' EXIT

# Clusters of voxels in 40 of the 64 cubes of 512 a side, and rays to them.
python3 - "$folder" <<'PYTHON'
import random, struct, sys
from pathlib import Path

folder = Path(sys.argv[1])
chance = random.Random(1)
cubes = [(x, y, z) for x in range(4) for y in range(4) for z in range(4)]
chance.shuffle(cubes)
voxels = {(0, 0, 0): (255, 0, 0), (2047, 2047, 2047): (255, 0, 0)}
for cube in cubes[:40]:
    for cluster in range(3):
        low = [512 * c + chance.randrange(500) for c in cube]
        for voxel in range(300):
            voxels[tuple(c + chance.randrange(12) for c in low)] = tuple(chance.randrange(256) for channel in range(3))
head = ["ply", "format ascii 1.0", f"element vertex {len(voxels)}"]
head += [f"property int {axis}" for axis in "xyz"] + [f"property uchar {c}" for c in ("red", "green", "blue")]
lines = head + ["end_header"] + [" ".join(map(str, v + c)) for v, c in voxels.items()]
(folder / "points.ply").write_text("\n".join(lines) + "\n")

targets = list(voxels)
with open(folder / "rays.bin", "wb") as rays:
    for ray in range(10000):
        # Long ways touch a page at each step: a few will do.
        target = chance.choice(targets)
        reach = 30 if ray % 100 else 2000
        origin = [t + chance.uniform(-reach, reach) for t in target]
        way = [t + 0.5 - o for t, o in zip(target, origin)]
        length = sum(w * w for w in way) ** 0.5
        rays.write(struct.pack("<6f", *origin, *(w / length for w in way)))
PYTHON

"$voxc" build "G(11)" "$folder/points.ply" -o "$folder/small.hvx" --quiet
"$voxc" trace "$folder/small.hvx" --rays "$folder/rays.bin" -o "$folder/expected" --device cpu --check 10000 --quiet

# FORMAT [PASS...]
check() {
  echo "== $1"
  "$voxc" build "$1" "$folder/points.ply" "${@:2}" --threads 1 -o "$folder/large.hvx" --quiet
  echo "bytes $(stat -c %s "$folder/large.hvx"), of which $((512 * $(stat -c %b "$folder/large.hvx"))) on disk"
  for where in cpu $device; do
    "$voxc" trace "$folder/large.hvx" --rays "$folder/rays.bin" -o "$folder/hits" --device "$where" --trusted --check 0 --quiet
    cmp "$folder/expected" "$folder/hits"
    echo "the same hits on $where"
  done
  rm "$folder/large.hvx"
}

check "R(2^3) R(9^3)" --granules
check "format granule=4 { level 1: raw(11, 11, 11) }"
