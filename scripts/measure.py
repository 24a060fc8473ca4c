#!/usr/bin/env python3
"""Measures the nested and the restart traversal on given rays, one core, and prints the table of docs/notes/2026-11-22-walks.md.

  measure.py VOXC INPUT FORMATS RAYS...    FORMATS: a list, label<TAB>format

Each format is built once; its traversals are traced in turn (A B A B), and a cell is the best of all repeats in million rays
per CPU second of the process. The errors are those of an evenly spread sample of the same rays.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

WALKS = {"nested": [], "restart": ["--restart-sv"]}
ROUNDS = 2
REPEATS = "2"
SAMPLE = "20000"


def run(*command):
    environment = {**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"}
    subprocess.run([str(part) for part in command], check=True, env=environment)


def trace(voxc, volume, rays, traversal, folder):
    run(voxc, "trace", volume, "--trusted", "--rays", rays, *WALKS[traversal], "--repeat", REPEATS, "--threads", 1,
        "--check", SAMPLE, "-o", folder / "hits", "--stats", folder / "stats", "--quiet")
    return json.loads((folder / "stats").read_text())


def wrong(error):
    return error["missed"] + error["ghost"] + error["wrong"]


def measure(voxc, source, form, rays, folder):
    volume = folder / "volume.hvx"
    run(voxc, "build", form, source, "--whole-level-dedup", "-o", volume, "--quiet", "--stats", folder / "stats")
    built = json.loads((folder / "stats").read_text())
    traversals = [traversal for traversal in WALKS if traversal == "nested" or "S(" in form or "G(" in form]
    best = {}
    errors = 0
    for file in rays:
        for _ in range(ROUNDS):
            for traversal in traversals:
                figures = trace(voxc, volume, file, traversal, folder)
                best[traversal, file] = max(best.get((traversal, file), 0), figures["mrays_per_cpu_s"])
                errors = max(errors, wrong(figures["error"]))
    cells = [f"{best[traversal, file]:.2f}" if (traversal, file) in best else "" for traversal in WALKS for file in rays]
    return [f"{built['bytes'] / 2**20:.2f}", f"{built['build_seconds']:.2f}", *cells, str(errors)]


def main():
    voxc, source, formats, *rays = sys.argv[1:]
    names = [f"{traversal} {i}" for traversal in WALKS for i in range(len(rays))]
    print("| Format | MiB | Build s |", " | ".join(names), "| Wrong |", flush=True)
    print("|---" * (4 + len(names)) + "|", flush=True)
    for line in Path(formats).read_text().splitlines():
        form = line.split("\t")[-1]
        with tempfile.TemporaryDirectory() as name:
            print("|", " | ".join([form, *measure(voxc, source, form, rays, Path(name))]), "|", flush=True)


if __name__ == "__main__":
    main()
