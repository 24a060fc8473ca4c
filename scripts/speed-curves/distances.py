#!/usr/bin/env python3
"""Speed against distance with bounds, in both precisions and by emitted headers, for docs/performance.md.

  distances.py VOXC SCENE EDGE OUT    traces on both devices; SCENE is of EDGE voxels an axis, a power of two; OUT is a folder for
                                      volumes, headers and distances.json

A cell is million rays a second of CPU time, one thread, the best of rounds in turn, and what that is of the speed from 1.5 edges.
"all" are rays with bounds between which everything lies, "far half" those that begin behind the middle of the volume. Each run is held
against the oracle, 2000 rays of it, and headers, t and all, against every hit of the exact tracer. Needs NumPy and g++.
"""
import json
import struct
import sys
from pathlib import Path

import numpy as np

from curves import HERE, camera, run

RAYS = 250_000
DISTANCES = (1.1, 1.5, 2.1, 3, 20, 300, 1e4, 1e6)
NEAR = 1.5
ROUNDS = 3
DEVICES = ("cpu", "llvmpipe")
OCTANTS = ("--octant-distances", "--df-packing")


def formats(edge):
    log2 = edge.bit_length() - 1
    yield f"D({log2 - 2}^3,15) M(2^3)", OCTANTS
    yield f"G({log2})", ("--whole-level-dedup",)
    yield f"R(4^3) G({log2 - 4})", ("--whole-level-dedup",)


def words_of(volume, file):
    """The words of a volume that is not compressed (docs/hvx.md)."""
    data = volume.read_bytes()
    count, offset = struct.unpack_from("<QQ", data, 168 + 40)
    file.write_bytes(data[offset:offset + 4 * count])


class Distances:
    def __init__(self, voxc, scene, edge, folder):
        self.voxc, self.scene, self.edge, self.folder = voxc, scene, edge, Path(folder).resolve()
        self.folder.mkdir(exist_ok=True)
        self.records = {}

    def rays(self, edges):
        file = self.folder / f"{edges:g}.rays"
        camera(edges, self.edge, RAYS).tofile(file)
        return file

    def bounds(self, edges):
        middle = np.linalg.norm(np.array([0.6, 0.35, 0.72])) * self.edge * edges
        return {"none": (), "all": ("--tmin", 0), "far half": ("--tmin", f"{middle:.9g}")}

    def trace(self, volume, edges, device, precision, bounds):
        stats = self.folder / "stats.json"
        run(self.voxc, "trace", volume, "--rays", self.rays(edges), "-o", self.folder / f"{edges:g}.hits", "--device", device,
            "--threads", 1, "--order", "given", "--repeat", 5, "--check", 2000, "--precision", precision,
            *bounds, "--stats", stats, "--quiet")
        figures = json.loads(stats.read_text())
        return figures["mrays_per_cpu_s"], sum(figures["error"][name] for name in ("missed", "ghost", "wrong"))

    def header(self, form, options, precision):
        """A program that traces by the functions of a header."""
        folder = self.folder / precision
        run(self.voxc, "compile", form, *options, "--precision", precision, "--emit=header", "--language", "cpp", "--name", "scene",
            "-o", folder, "--quiet")
        run("g++", "-O3", "-march=native", "-std=c++20", "-I", folder, HERE / "header-cpu.cpp", "-o", folder / "trace")
        return folder / "trace"

    def add(self, row, edges, speed, wrong):
        best, all_wrong = self.records.get((row, edges), (0, 0))
        self.records[row, edges] = max(best, speed), all_wrong + wrong

    def measure_round(self, form, volume, programs):
        for edges in DISTANCES:
            for device in DEVICES:
                for name, bounds in self.bounds(edges).items():
                    for precision in ("fast", "exact"):
                        self.add((form, device, name, precision), edges, *self.trace(volume, edges, device, precision, bounds))
            self.trace(volume, edges, "cpu", "exact", ())
            for precision, program in programs.items():
                text = run(program, self.folder / "words", self.rays(edges), self.folder / f"{edges:g}.hits")
                speed, wrong = text.split()
                self.add((form, "cpu, header", "none", precision), edges, float(speed), int(wrong))

    def measure(self):
        for form, options in formats(self.edge):
            volume = self.folder / "volume.hvx"
            run(self.voxc, "build", form, self.scene, *options, "-o", volume, "--quiet")
            words_of(volume, self.folder / "words")
            programs = {precision: self.header(form, options, precision) for precision in ("fast", "exact")}
            for _ in range(ROUNDS):
                self.measure_round(form, volume, programs)
            self.print_rows(form)
        rows = [{"row": row, "edges": edges, "mrays_per_cpu_s": speed, "wrong": wrong}
                for (row, edges), (speed, wrong) in self.records.items()]
        (self.folder / "distances.json").write_text(json.dumps(rows, indent=1) + "\n")

    def print_rows(self, form):
        print(f"| {form} | " + " | ".join(f"{edges:g}" for edges in DISTANCES) + " | wrong |")
        for row in dict.fromkeys(row for row, _ in self.records if row[0] == form):
            near = self.records[row, NEAR][0]
            cells = [f"{self.records[row, edges][0]:.1f} {self.records[row, edges][0] / near:.2f}" for edges in DISTANCES]
            wrong = sum(self.records[row, edges][1] for edges in DISTANCES)
            print(f"| {', '.join(row[1:])} | " + " | ".join(cells) + f" | {wrong} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    Distances(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]).measure()
