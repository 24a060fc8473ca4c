#!/usr/bin/env python3
"""What exact hits cost beside fast ones, over many formats, for docs/performance.md.

  precision-costs.py VOXC SCENE EDGE OUT [FORMATS...]  traces on both devices; SCENE is of EDGE voxels an axis; FORMATS are lists, a line
                                                       each: label<TAB>format, as those of the paper; without lists, the formats of
                                                       docs/performance.md. OUT is a folder for volumes and costs.json, to which each
                                                       format is added once
  precision-costs.py --table OUT                       prints the table of costs.json

The kinds of rays are those of measured_rays.py. A cost is the CPU time of `exact` over that of `fast`, one thread, medians of rounds in
turn. Of each, 50 hits of `exact` are held against the oracle. Needs NumPy.
"""
import json
import statistics
import sys
from pathlib import Path

from measured_rays import run, write_kinds

RAYS = 40_000
ROUNDS = 5
CHECKED = 50
DEVICES = ("cpu", "llvmpipe")
OCTANTS = ("--octant-distances", "--df-packing")
OF_PERFORMANCE = (
    ("D(7^3,15) M(2^3)", OCTANTS),
    ("D(5^3,15) M(2^3) M(2^3)", (*OCTANTS, "--share-grids")),
    ("D(5^3,15) D(2^3,15) M(2^3)", (*OCTANTS, "--share-grids", "--values-apart")),
    ("D(6^3,15) M(3^3)", OCTANTS),
    ("G(9)", ("--whole-level-dedup",)),
    ("R(4^3) G(5)", ("--whole-level-dedup",)),
    ("R(3^3) R(3^3) R(3^3)", ()),
    ("G(9)", ("--whole-level-dedup", "--occupancy", "--inline-leaves")),
    ("R(1^3) M(2^3) M(2^3) M(2^3) M(2^3)", ("--share-grids", "--occupancy")),
    ("R(1^3) M(2^3) M(2^3) M(2^3) M(2^3)", ("--share-grids", "--payload=auto", "--short-pointers=auto")),
)


def measure(voxc, volume, rays, folder):
    """Of each device, the cost and both speeds; and how many rays were wrong."""
    stats = folder / "stats.json"
    devices = [word for device in DEVICES for word in ("--device", device)]
    run(voxc, "accuracy", volume, "--trusted", "--rays", rays, *devices, "--threads", 1, "--traversals", "stack", "--repeat", ROUNDS,
        "--check", CHECKED, "-o", folder / "plots", "--stats", stats, "--quiet", folder=folder)
    speeds, wrong = {}, 0
    for variant in json.loads(stats.read_text())["variants"]:
        device = next(name for name in DEVICES if variant["device"].startswith(name))
        speeds[device, variant["precision"]] = variant["mrays_per_cpu_s"]
        if variant["precision"] == "exact":
            wrong += sum(variant["error"][what] for what in ("missed", "ghost", "wrong"))
    costs = {device: {"cost": speeds[device, "fast"] / speeds[device, "exact"], "exact": speeds[device, "exact"]} for device in DEVICES}
    return costs, wrong


def formats(lists):
    for form, options in () if lists else OF_PERFORMANCE:
        yield "performance", form, options
    for name in lists:
        for line in Path(name).read_text().splitlines():
            yield Path(name).stem, line.split("\t")[-1], ("--whole-level-dedup",)


def measure_all(voxc, scene, edge, out, lists):
    folder = Path(out).resolve()
    folder.mkdir(exist_ok=True)
    results = folder / "costs.json"
    records = json.loads(results.read_text()) if results.exists() else []
    files = write_kinds(folder, edge, RAYS)
    for group, form, options in formats(lists):
        if any((r["group"], r["format"], r["options"]) == (group, form, list(options)) for r in records):
            continue
        volume = folder / "volume.hvx"
        run(voxc, "build", form, scene, *options, "--threads", 1, "-o", volume, "--quiet", folder=folder)
        record = {"group": group, "format": form, "options": options, "kinds": {}, "wrong": 0}
        for kind, file in files.items():
            record["kinds"][kind], wrong = measure(voxc, volume, file, folder)
            record["wrong"] += wrong
        records.append(record)
        results.write_text(json.dumps(records, indent=1))
        print(group, form, {kind: {d: round(c["cost"], 2) for d, c in row.items()} for kind, row in record["kinds"].items()}, flush=True)


def table(out):
    records = json.loads((Path(out) / "costs.json").read_text())
    groups = list(dict.fromkeys(record["group"] for record in records))
    print("| Formats | Device |", " | ".join(records[0]["kinds"]), "|")
    print("|---" * (2 + len(records[0]["kinds"])) + "|")
    for group in groups:
        rows = [record for record in records if record["group"] == group]
        for device in DEVICES:
            cells = []
            for kind in records[0]["kinds"]:
                costs = [row["kinds"][kind][device]["cost"] for row in rows]
                worst = max(rows, key=lambda row: row["kinds"][kind][device]["cost"])
                cells.append(f"{statistics.geometric_mean(costs):.2f}, {sum(cost > 1.1 for cost in costs)} of {len(costs)}, "
                             f"{max(costs):.2f} `{worst['format']}`")
            print(f"| {group} | {device} |", " | ".join(cells), "|")
    print(f"{sum(record['wrong'] for record in records)} rays wrong")


if __name__ == "__main__":
    if sys.argv[1] == "--table":
        table(sys.argv[2])
    else:
        measure_all(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4], sys.argv[5:])
