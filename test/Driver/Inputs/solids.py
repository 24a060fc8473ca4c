# solids.py FILE KIND: a text STL of a box from 0 to 10, 12 and 14, each side of 2 x 2 squares; KIND says what is the matter with it.
import itertools
import sys

path, kind = sys.argv[1:]
size = (10, 12, 14)
triangles = []
for axis, at, i, j in itertools.product(range(3), (0, 1), range(2), range(2)):
    square = []
    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
        corner = [0, 0, 0]
        corner[axis] = at * size[axis]
        corner[(axis + 1) % 3] = u * size[(axis + 1) % 3] / 2
        corner[(axis + 2) % 3] = v * size[(axis + 2) % 3] / 2
        square.append(tuple(corner))
    if at == 0:
        square.reverse()
    triangles += [(square[0], square[1], square[2]), (square[0], square[2], square[3])]
if kind in ("holed", "double-holed"):
    del triangles[5]
    del triangles[30]
if kind == "open":
    triangles = [t for t in triangles if any(corner[2] != 14 for corner in t)]
if kind.startswith("double"):
    triangles += [t[::-1] for t in triangles]
with open(path, "w") as file:
    print("solid", file=file)
    for triangle in triangles:
        print("facet normal 0 0 0\nouter loop", file=file)
        for corner in triangle:
            print("vertex", *corner, file=file)
        print("endloop\nendfacet", file=file)
    print("endsolid", file=file)
