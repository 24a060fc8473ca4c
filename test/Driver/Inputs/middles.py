"""Compares a scene with its surface, voxelized again: middles.py SCENE.raw SOLID.raw SIDE

SCENE has SIDE^3 cells. SOLID was made of its faces at twice the resolution, half of a small cell lower, and filled: the small cells
in the middle of the cells, those of odd coordinates, must be full where the scene is, and nowhere else.
"""
import sys

import numpy

scene, solid = (numpy.fromfile(name, dtype=numpy.uint32) for name in sys.argv[1:3])
side = int(sys.argv[3])
scene = scene.reshape(side, side, side)
solid = solid.reshape(2 * side + 1, 2 * side + 1, 2 * side + 1)[1::2, 1::2, 1::2]
assert ((scene != 0) == (solid != 0)).all(), ((scene != 0) != (solid != 0)).sum()
print("equal:", (scene != 0).sum(), "voxels")
