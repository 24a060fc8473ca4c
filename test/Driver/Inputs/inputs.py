#!/usr/bin/env python3
"""Inputs of each kind, a few voxels each: inputs.py FOLDER; or holds an attribute to samples: inputs.py FOLDER check V.hvx"""
import json
import struct
import subprocess
import sys
from pathlib import Path

# A ball of -1000 to 900 in air of -1024, 3 mm from slice to slice.
WIDTH, HEIGHT, DEPTH = 12, 10, 6


def hounsfield(x, y, z):
    distance = (x - 6) ** 2 + (y - 5) ** 2 + (3 * (z - 3)) ** 2
    return -1024 if distance > 25 else 900 - 76 * distance


def samples():
    return [hounsfield(x, y, z) for z in range(DEPTH) for y in range(HEIGHT) for x in range(WIDTH)]


def nifti():
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, WIDTH, HEIGHT, DEPTH, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 4, 16)  # int16
    struct.pack_into("<8f", header, 76, 1, 1, 1, 3, 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    struct.pack_into("<2h", header, 252, 0, 1)
    struct.pack_into("<12f", header, 280, 1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 3, 30)
    header[344:348] = b"n+1\0"
    return bytes(header) + struct.pack(f"<{len(samples())}h", *samples())


def chunk(name, content):
    return name + struct.pack("<2I", len(content), 0) + content


def vox(models, materials=()):
    chunks = b""
    for cells in models:
        chunks += chunk(b"SIZE", struct.pack("<3I", 4, 4, 4))
        chunks += chunk(b"XYZI", struct.pack("<I", len(cells)) + b"".join(bytes(cell) for cell in cells))
    for number, kind in materials:
        chunks += chunk(b"MATL", struct.pack("<3I", number, 1, 5) + b"_type" + struct.pack("<I", len(kind)) + kind)
    return b"VOX " + struct.pack("<I", 150) + b"MAIN" + struct.pack("<2I", 0, len(chunks)) + chunks


def make(folder):
    (folder / "scan.nii").write_bytes(nifti())
    (folder / "cut.obj").write_text("v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\nf 1 3 4\n")
    (folder / "points.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n0 0 0\n1 2 3\n-1 0.5 0\n")
    (folder / "walk.vox").write_bytes(vox([[(0, 0, 0, 1)], [(1, 0, 0, 2)], [(2, 0, 0, 3), (3, 3, 3, 9)]]))
    (folder / "lamp.vox").write_bytes(vox([[(0, 0, 0, 7), (1, 1, 1, 200)]], [(7, b"_diffuse"), (200, b"_emit")]))
    (folder / "dots.binvox").write_bytes(b"#binvox 1\ndim 2 2 2\ntranslate 0 0 0\nscale 2\ndata\n\1\3\0\5")


def check(folder, volume):
    """Of each voxel, in Morton order, the attribute is the sample: z is up in the scan, and y in the volume."""
    code = lambda cell: sum((c >> bit & 1) << (3 * bit + axis) for axis, c in enumerate(cell) for bit in range(8))
    threshold = float(subprocess.run(["sed", "-n", "s/.*threshold=\\([^ ]*\\).*/\\1/p"], input=json.loads(
        (folder / "info.json").read_text())["provenance"], capture_output=True, text=True).stdout)
    voxels = {code((x, z, HEIGHT - 1 - y)): hounsfield(x, y, z)
              for z in range(DEPTH) for y in range(HEIGHT) for x in range(WIDTH) if hounsfield(x, y, z) >= threshold}
    expected = struct.pack(f"<{len(voxels)}i", *(voxels[place] for place in sorted(voxels)))
    negative = sum(value < 0 for value in voxels.values())
    print(len(voxels), "voxels,", negative, "below 0,", "equal" if expected in volume.read_bytes() else "other samples")


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    make(folder) if len(sys.argv) == 2 else check(folder, Path(sys.argv[3]))
