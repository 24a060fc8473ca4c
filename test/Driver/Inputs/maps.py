#!/usr/bin/env python3
"""Writes models and points with coordinates of maps: maps.py FOLDER

near.obj and the like lie at the origin; far.obj and the like are the same, moved to where UTM has them. Corners are multiples of
2^-10, so that moving them rounds nothing.
"""
import random
import sys
from pathlib import Path

UTM = (500123.25, 200.25, 5412345.5)
random.seed(5)
CORNERS = [tuple(random.randrange(8193) / 1024 for _ in range(3)) for _ in range(90)]


def line(word, corner, origin):
    return word + " ".join(f"{c + o:.10f}" for c, o in zip(corner, origin)) + "\n"


def obj(origin):
    faces = "".join(f"f {i} {i + 1} {i + 2}\n" for i in range(1, len(CORNERS), 3))
    return "".join(line("v ", c, origin) for c in CORNERS) + faces


def stl(origin):
    text = "solid maps\n"
    for i in range(0, len(CORNERS), 3):
        loop = "".join(line("vertex ", c, origin) for c in CORNERS[i:i + 3])
        text += "facet normal 0 0 0\nouter loop\n" + loop + "endloop\nendfacet\n"
    return text + "endsolid maps\n"


def ply(origin, kind="double", faces=True):
    text = f"ply\nformat ascii 1.0\nelement vertex {len(CORNERS)}\n"
    text += "".join(f"property {kind} {axis}\n" for axis in "xyz")
    if faces:
        text += f"element face {len(CORNERS) // 3}\nproperty list uchar int vertex_indices\n"
    text += "end_header\n" + "".join(line("", c, origin) for c in CORNERS)
    return text + ("".join(f"3 {i} {i + 1} {i + 2}\n" for i in range(0, len(CORNERS), 3)) if faces else "")


folder = Path(sys.argv[1])
for name, origin in ("near", (0, 0, 0)), ("far", UTM):
    (folder / f"{name}.obj").write_text(obj(origin))
    (folder / f"{name}.stl").write_text(stl(origin))
    (folder / f"{name}.ply").write_text(ply(origin))
    (folder / f"{name}-float.ply").write_text(ply(origin, "float"))
    (folder / f"{name}-points.ply").write_text(ply(origin, faces=False))
    (folder / f"{name}-points-float.ply").write_text(ply(origin, "float", faces=False))
# Doubles that float32 rounds up: the point with the least of each coordinate lies on a face of the box.
(folder / "low.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                                "property double z\nend_header\n0.1 0.1 0.1\n0.5 0.5 0.5\n1.1 1.1 1.1\n")
