"""Compares a scene with its surface, voxelized again: middles.py SCENE.raw SOLID.raw SIDE

SCENE has SIDE^3 cells. SOLID was made of its faces at twice the resolution, half of a small cell lower, and filled: the small cells
in the middle of the cells, those of odd coordinates, must be full where the scene is, and nowhere else.
"""
import sys
from array import array

scene, solid = (array("I", open(name, "rb").read()) for name in sys.argv[1:3])
side = int(sys.argv[3])
wide = 2 * side + 1
assert len(scene) == side**3 and len(solid) == wide**3
voxels = 0
for z in range(side):
    for y in range(side):
        for x in range(side):
            full = scene[x + side * (y + side * z)] != 0
            middle = solid[2 * x + 1 + wide * (2 * y + 1 + wide * (2 * z + 1))] != 0
            assert full == middle, (x, y, z)
            voxels += full
print("equal:", voxels, "voxels")
