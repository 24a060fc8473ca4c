"""late-colour.py FILE: points of two colours, a whole number of blocks of 128, and then three of a third."""
import sys

points = [(x, y, z, 255, 0 if (x + y + z) % 2 else 255, 0) for x in range(8) for y in range(8) for z in range(8)]
points += [(8 + x, 8, 8, 0, 0, 255) for x in range(3)]
with open(sys.argv[1], "w") as file:
    file.write(f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n")
    for point in points:
        file.write(" ".join(map(str, point)) + "\n")
