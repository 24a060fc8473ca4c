#!/usr/bin/env python3
"""What --order auto takes beside the better of given and binned, for docs/performance.md.

  order-costs.py VOXC SCENE EDGE OUT   traces on both devices; SCENE is of EDGE voxels an axis; OUT is a folder for volumes and orders.json
  order-costs.py --table OUT           prints the table of orders.json

Speeds are of one thread, million rays a CPU second, what ordering takes included, medians of rounds in turn, each the best of repeated
calls. Of each run, 50 hits are held against the oracle. Needs NumPy.
"""
import json
import statistics
import sys
from pathlib import Path

import numpy as np
from measured_rays import kinds, run, scattered, write

ROUNDS = 5
CHECKED = 50
DEVICES = ("cpu", "llvmpipe")
ORDERS = ("given", "binned", "auto")
BATCHES = (10_000, 1_000_000)
OCTANTS = ("--octant-distances", "--df-packing")
FORMATS = (
    ("D(7^3,15) M(2^3)", OCTANTS),
    ("G(9)", ("--whole-level-dedup",)),
    ("R(4^3) G(5)", ("--whole-level-dedup",)),
    ("R(3^3) R(3^3) R(3^3)", ()),
)


def begin_in_voxels(voxc, volume, rays, folder):
    """Rays whose origins are in filled voxels, which are over at once: from what other rays hit."""
    hits = folder / "begin.hits"
    run(voxc, "trace", volume, "--rays", rays, "-o", hits, "--threads", 1, "--device", "cpu", "--check", 0, "--quiet", folder=folder)
    found = np.fromfile(hits, dtype=[("voxel", "<i4", 3), ("rgba", "<u4"), ("t", "<f4"), ("steps", "<u4")])
    voxels = found["voxel"][np.isfinite(found["t"]) & (found["voxel"][:, 0] >= 0)]
    random = np.random.default_rng(6)
    count = len(found)
    origins = voxels[random.integers(0, len(voxels), count)] + random.uniform(0.1, 0.9, (count, 3))
    return origins, random.normal(size=(count, 3))


def measure(voxc, volume, rays, device, folder):
    """The median speed of each order, and how many rays were wrong."""
    stats, speeds, wrong = folder / "stats.json", {order: [] for order in ORDERS}, 0
    for _ in range(ROUNDS):
        for order in ORDERS:
            run(voxc, "trace", volume, "--trusted", "--rays", rays, "-o", folder / "hits", "--device", device, "--threads", 1, "--order", order,
                "--repeat", 5, "--check", CHECKED, "--stats", stats, "--quiet", folder=folder)
            figures = json.loads(stats.read_text())
            speeds[order].append(figures["mrays_per_cpu_s"])
            wrong += sum(figures["error"][what] for what in ("missed", "ghost", "wrong"))
    return {order: statistics.median(list_) for order, list_ in speeds.items()}, wrong


def measure_all(voxc, scene, edge, out):
    folder = Path(out).resolve()
    folder.mkdir(exist_ok=True)
    records = []
    for form, options in FORMATS:
        volume = folder / "volume.hvx"
        run(voxc, "build", form, scene, *options, "--threads", 1, "-o", volume, "--quiet", folder=folder)
        for count in BATCHES:
            rays = kinds(edge, count)
            outside = np.random.default_rng(7).uniform(-edge, 2 * edge, (count, 3))
            rays["from around, scattered"] = scattered(edge, outside, np.random.default_rng(8))
            rays["from voxels"] = begin_in_voxels(voxc, volume, write(folder / "rays", *rays["near, scattered"]), folder)
            for kind, pair in rays.items():
                file = write(folder / "rays", *pair)
                for device in DEVICES:
                    speeds, wrong = measure(voxc, volume, file, device, folder)
                    records.append({"format": form, "rays": count, "kind": kind, "device": device, "speeds": speeds, "wrong": wrong})
                    print(records[-1], flush=True)
                (folder / "orders.json").write_text(json.dumps(records, indent=1))


def table(out):
    records = json.loads((Path(out) / "orders.json").read_text())
    print("| Rays | Device | auto over the better, the least of formats | given / binned / auto there |")
    print("|---|---|---|---|")
    for count in BATCHES:
        for kind in dict.fromkeys(record["kind"] for record in records):
            for device in DEVICES:
                rows = [r for r in records if (r["rays"], r["kind"], r["device"]) == (count, kind, device)]
                ratio = {r["format"]: r["speeds"]["auto"] / max(r["speeds"]["given"], r["speeds"]["binned"]) for r in rows}
                worst = min(rows, key=lambda r: ratio[r["format"]])
                speeds = " / ".join(f"{worst['speeds'][order]:.2f}" for order in ORDERS)
                print(f"| {count:,}: {kind} | {device} | {ratio[worst['format']]:.2f} `{worst['format']}` | {speeds} |")
    print(f"{len(records)} situations, {sum(record['wrong'] for record in records)} rays wrong")


if __name__ == "__main__":
    if sys.argv[1] == "--table":
        table(sys.argv[2])
    else:
        measure_all(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4])
