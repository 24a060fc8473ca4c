#!/usr/bin/env bash
# Proves that the pack of a GPU day is complete: it runs in a clean Debian 12 root that has Mesa's driver for the processor and xz, and
# nothing of ours; twice, so that it goes on where it ended.
#
# Usage: scripts/gpu-day-chroot.sh [BUILD]
# BUILD (default: build/release) has been built. Needs root and debootstrap (scripts/packages-full.txt).
set -euo pipefail
cd "$(dirname "$0")/.."
readonly build="${1:-build/release}"
readonly desk=/srv/check # In the root: where the pack is, and what it measures.
work="$(mktemp -d -p "${TMPDIR:-/var/tmp}" gpu-day.XXXXXX)"
root=$work/root
trap 'umount -q "$root/proc" || true; umount -q "$root/dev" || true; rm -rf --one-file-system "$work"' EXIT

scripts/gpu-day.sh pack "$work/day.tar.xz" --bin "$build/bin" --scene terrain=builtin:terrain:256
mirror="$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | awk '$2 == "bookworm" { print $1; exit }')"
debootstrap --variant=minbase --include=mesa-vulkan-drivers,xz-utils bookworm "$root" "$mirror" > /dev/null
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mkdir -p "$root$desk"
cp scripts/gpu-day.sh "$work/day.tar.xz" "$root$desk"
measure() { # SECONDS
  chroot "$root" /usr/bin/env -i PATH=/usr/bin:/bin HOME="$desk" GPU_DAY_SIZE=96x54 GPU_DAY_RAYS=2000000 \
    sh "$desk/gpu-day.sh" run "$desk/day.tar.xz" "$desk/out" "$1"
}
measure 1 > "$work/first" # Ends at once.
grep -q 'run it again to go on' "$work/first"
measure 1800 > "$work/second"
python3 - "$root$desk/out/gpu-day.json" << 'PYTHON'
import json
import sys

day = json.load(open(sys.argv[1]))
wrong, rows = 0, 0
for cell in day["cells"]:
    for kind, kernel in cell["kernels"].items():
        for row in kernel.get("rows", []):
            rows += 1
            if "fast" not in kind:
                wrong += sum(row["error"].values())
checked = [found for cell in day["lattice"] for found in cell["lattice"].values()]
wrong += sum(found["wrong"] for found in checked)
print(f"{rows} rows, {len(checked)} checks of hard rays, {wrong} wrong")
failed = {what: why for what, why in day["failed"].items() if "CUDA" not in why}
print(failed or "nothing failed but CUDA, of which there is no driver")
sys.exit(wrong > 0 or rows < 100 or len(checked) != 14 or bool(failed))
PYTHON
"$build/bin/voxc" bench report "$root$desk/out" -o "$work/report.html" --quiet
