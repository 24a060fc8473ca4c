#!/usr/bin/env python3
"""Speed against distance, batch and extent, beside hand-written tracers, for docs/performance.md.

  curves.py measure VOXC PEERS OUT    traces on both devices; PEERS has the tracers and their scene (t_own.cpp, t_aadf.cpp, scene.h,
                                      dump.cpp, vkbench.cpp, aadf.comp), which are not part of voxc; OUT is a folder for scenes,
                                      volumes and curves.json
  curves.py draw OUT PICTURE.svg      draws curves.json

Each figure is million rays a second of CPU time, one thread, the best of rounds in turn. Each of voxc's runs is held against the oracle
on 2000 rays, and counts what was wrong. Needs NumPy, Matplotlib, g++, glslangValidator.
"""
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
DEVICES = ("cpu", "llvmpipe")
DISTANCES = (1.1, 1.5, 1.9, 2.1, 3, 6, 20, 300, 1e4, 1e6)
BATCHES = (1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000)
EXTENTS = (64, 128, 256, 512, 1024, 2048)
ROUNDS = 2
MIDDLE = 512
ONE = {**os.environ, "LP_NUM_THREADS": "1", "MESA_SHADER_CACHE_DISABLE": "true"}


def run(*command, **more):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True, env={**ONE, **more}).stdout


def camera(edges, side, count):
    """Rays of a camera so many edges from the middle of a volume, which is as large in the picture each time."""
    width = round(count**0.5)
    steps = np.linspace(0.05, 0.95, width)
    grid = np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2) * 2 - 1
    middle = np.full(3, side / 2)
    eye = middle + np.array([0.6, 0.35, 0.72]) * side * edges
    forward = (middle - eye) / np.linalg.norm(middle - eye)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    half = 0.6 * side / np.linalg.norm(middle - eye)
    direction = forward + grid[:, :1] * half * right + grid[:, 1:] * half * up
    return np.concatenate([np.tile(eye, (len(direction), 1)), direction], 1).astype("<f4")


class Bench:
    def __init__(self, voxc, peers, folder):
        self.voxc, self.peers, self.folder = voxc, Path(peers).resolve(), Path(folder).resolve()
        self.folder.mkdir(exist_ok=True)
        self.records = []
        build = ("g++", "-O3", "-march=native", "-std=c++20", "-I", self.peers, "-pthread")
        run(*build, self.peers / "dump.cpp", "-o", self.folder / "dump")
        run(*build, self.peers / "t_aadf.cpp", "-o", self.folder / "write-octants")
        run(*build, HERE / "peer-cpu.cpp", "-o", self.folder / "tree64")
        run(*build, "-DOCTANTS", HERE / "peer-cpu.cpp", "-o", self.folder / "octants")
        run(*build, HERE / "peer-vulkan.cpp", "-o", self.folder / "vulkan", "-lvulkan")
        run("glslangValidator", "-V", self.peers / "aadf.comp", "-o", self.folder / "octants.spv")

    def volume(self, side):
        volume = self.folder / f"{side}.hvx"
        if not volume.exists():
            run(self.folder / "dump", side, self.folder / f"scene{side}")
            form = f"D({side.bit_length() - 3}^3,15) M(2^3)"
            run(self.voxc, "build", form, self.folder / f"scene{side}.ply", "--octant-distances", "--df-packing", "-o", volume, "--quiet")
            run(self.folder / "write-octants", side, self.folder / f"octants{side}.bin")
        return volume

    def record(self, curve, at, device, tracer, speed, wrong=None):
        self.records.append({"curve": curve, "at": at, "device": device, "tracer": tracer, "mrays_per_cpu_s": speed, "wrong": wrong})
        print(self.records[-1], flush=True)

    def trace(self, curve, at, side, rays):
        """The rays on both devices, and by the peers, where these can."""
        file = self.folder / f"{curve}{at}.rays"
        rays.tofile(file)
        stats = self.folder / "stats.json"
        for device in DEVICES:
            best, wrong = 0, 0
            for _ in range(ROUNDS):
                run(self.voxc, "trace", self.volume(side), "--rays", file, "-o", self.folder / "hits", "--device", device, "--threads", 1,
                    "--repeat", 5, "--check", min(2000, len(rays)), "--stats", stats, "--quiet")
                figures = json.loads(stats.read_text())
                best = max(best, figures["mrays_per_cpu_s"])
                wrong += sum(figures["error"][name] for name in ("missed", "ghost", "wrong"))
            self.record(curve, at, device, "voxc", best, wrong)
        for tracer in ("tree64", "octants"):
            speed = max(float(run(self.folder / tracer, side, file).split()[0]) for _ in range(ROUNDS))
            self.record(curve, at, "cpu", f"hand-written, {tracer}", speed)
        if 1_000_000 <= len(rays) <= 1920 * 1080:  # As many rays as it takes, or they would be others.
            text = run(self.folder / "vulkan", side, self.folder / "octants.spv", self.folder / f"octants{side}.bin", "t64", 6, RAYS=str(file))
            speed = max(float(line.split("Mr/cpu-s=")[1].split()[0]) for line in text.splitlines() if "Mr/cpu-s=" in line)
            self.record(curve, at, "llvmpipe", "hand-written, octants", speed)
        file.unlink()

    def measure(self):
        for edges in DISTANCES:
            self.trace("distance", edges, MIDDLE, camera(edges, MIDDLE, 1_000_000))
        rays = camera(1.5, MIDDLE, 10_000_000)
        for batch in BATCHES:
            middle = len(rays) // 2 + 1000
            self.trace("batch", batch, MIDDLE, rays[:batch] if batch > middle else rays[middle:middle + batch])
        for side in EXTENTS:
            self.trace("extent", side, side, camera(1.5, side, 1_000_000))
        (self.folder / "curves.json").write_text(json.dumps(self.records, indent=1) + "\n")


def draw(folder, picture):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "voxc", "svg.fonttype": "none", "font.size": 9})
    from matplotlib import pyplot
    records = json.loads((Path(folder) / "curves.json").read_text())
    labels = {"distance": "edges from the middle of 512³", "batch": "rays a call", "extent": "voxels an axis"}
    colours = {"voxc": "#1f5fa8", "hand-written, tree64": "#8a8a8a", "hand-written, octants": "#c46a1b"}
    figure, axes = pyplot.subplots(2, 3, figsize=(10, 5.4), sharey="row", layout="constrained")
    for row, device in enumerate(DEVICES):
        for column, curve in enumerate(labels):
            plot = axes[row][column]
            for tracer, colour in colours.items():
                points = [r for r in records if (r["curve"], r["device"], r["tracer"]) == (curve, device, tracer)]
                plot.plot([r["at"] for r in points], [r["mrays_per_cpu_s"] for r in points], "o-", ms=3, color=colour, label=tracer)
            plot.set_xscale("log")
            plot.set_yscale("log")
            plot.grid(alpha=0.25)
            plot.set_xlabel(labels[curve])
        axes[row][0].set_ylabel(f"{device}: million rays a CPU second")
    axes[0][0].legend(frameon=False, fontsize=8)
    figure.savefig(picture, metadata={"Date": None})


def main():
    if len(sys.argv) == 5 and sys.argv[1] == "measure":
        Bench(*sys.argv[2:]).measure()
    elif len(sys.argv) == 4 and sys.argv[1] == "draw":
        draw(*sys.argv[2:])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
