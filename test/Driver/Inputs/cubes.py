# cubes.py FILE [-]LOW,HIGH...: an OBJ of cubes from LOW to HIGH on each axis; one with a minus faces inwards.
# LOW,HIGH,N leaves out all but N of the 12 triangles.
import sys

path, *cubes = sys.argv[1:]
corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
squares = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
with open(path, "w") as file:
    for number, cube in enumerate(cubes):
        low, high, *count = (float(part) for part in cube.lstrip("-").split(","))
        for corner in corners:
            print("v", *((low, high)[side] for side in corner), file=file)
        triangles = [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
        for triangle in triangles[: int(count[0]) if count else 12]:
            turned = triangle[::-1] if cube.startswith("-") else triangle
            print("f", *(8 * number + 1 + corner for corner in turned), file=file)
