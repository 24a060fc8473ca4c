#!/usr/bin/env python3
"""Runs every example of the help texts in an empty folder: examples.py VOXC

What the examples name is put there before: a model in several kinds of files, a volume, rays. Numbers that only cost time are made
smaller, and what needs a scheduler or a display is left out.
"""
import random
import re
import struct
import subprocess
import sys

PYRAMID = "v 0 0 0\nv 9 0 0\nv 0 0 9\nv 4 8 4\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
PLY = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
9 0 0
0 0 9
4 8 4
3 0 1 3
3 0 2 3
"""
SMALLER = (("G(5)", "G(2)"), ("G(7)", "G(2)"), ("G(9)", "G(4)"), ("--budget 60s", "--budget 25s"), ("--rays 100000", "--rays 2000"),
           ("--parts 64", "--parts 4"), ("--resolution 1024", "--resolution 64"), ("--resolution 256", "--resolution 64"))
# Orders in which one makes what another takes.
FIRST = ("build", "plan", "split")


def lines_of(voxc, command):
    text = subprocess.run([voxc, command, "--help"], check=True, capture_output=True, text=True).stdout
    block = re.search(r"^Examples:\n((?:  .*\n)+)", text, re.MULTILINE)
    # A line that was broken goes on deeper, as what it does stands deeper, too: an example begins with "voxc".
    return re.findall(r"^  (voxc .*)$", block.group(1), re.MULTILINE) if block else []


def commands(voxc):
    text = subprocess.run([voxc, "--help"], check=True, capture_output=True, text=True).stdout
    return re.findall(r"^  ([a-z][a-z-]*) ", text, re.MULTILINE)


def prepare(voxc):
    def run(*arguments):
        subprocess.run([voxc, *arguments, "--quiet"], check=True)

    for name in ("model.obj", "city.obj"):
        open(name, "w").write(PYRAMID)
    open("model.ply", "w").write(PLY)
    run("build", "R(2, 2, 2) G(2)", "builtin:terrain", "-o", "whole.hvx")
    run("export", "whole.hvx", "-o", "model.vox")
    for i in range(3):
        run("split", "whole.hvx", "--fragment", f"{i}/3", "-o", f"part-{i}.hvf")
    rays = random.Random(1)
    open("rays.bin", "wb").write(b"".join(struct.pack("<6f", *(rays.uniform(-9, 70) for _ in range(6))) for _ in range(100)))


def main():
    voxc = sys.argv[1]
    prepare(voxc)
    names = sorted(commands(voxc), key=lambda name: name not in FIRST)
    failed = []
    for line in (line for name in names for line in lines_of(voxc, name)):
        if "--slurm" in line or line.startswith("voxc view"):
            continue
        for long, short in SMALLER:
            line = line.replace(long, short)
        done = subprocess.run(["bash", "-c", re.sub(r"^voxc", voxc, line)], capture_output=True, text=True)
        if done.returncode:
            failed.append(f"{line}: exit code {done.returncode}\n{done.stderr}")
    sys.exit("\n".join(failed) or None)


if __name__ == "__main__":
    main()
