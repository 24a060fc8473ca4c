"""Writes a wall of voxels as points, and rays to it from far away whose one coordinate is next to 0 and all but still."""
import random
import struct
import sys

points, rays = sys.argv[1:]
cells = [(5, y, z) for y in range(16) for z in range(4)]
with open(points, "w") as ply:
    ply.write("ply\nformat ascii 1.0\n")
    ply.write(f"element vertex {len(cells)}\nproperty int x\nproperty int y\nproperty int z\nend_header\n")
    ply.writelines(f"{x} {y} {z}\n" for x, y, z in cells)
random.seed(3)
with open(rays, "wb") as file:
    for _ in range(5000):
        origin = (-2.0 ** random.uniform(14, 33), random.uniform(0, 16), 2.0 ** random.uniform(-29.9, -24))
        slope = 10.0 ** random.uniform(-30, -8)
        file.write(struct.pack("6f", *origin, 1.0, 0.0, random.choice([slope, -slope])))
