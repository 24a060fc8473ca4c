# queries.py HITS OTHER FIELDS: whether OTHER has the hits of HITS, with 0 where FIELDS (of vct: voxel, colour, t) are not.
import struct, sys

def records(path):
    with open(path, "rb") as file:
        return list(struct.iter_unpack("<3i3I", file.read()))

def reduced(hit, fields):
    if hit[0] < 0:
        return hit[:5]
    voxel, colour, t = hit[:3], hit[3], hit[4]
    return (*(voxel if "v" in fields else (0, 0, 0)), colour if "c" in fields else 0, t if "t" in fields else 0)

hits, others = records(sys.argv[1]), records(sys.argv[2])
expected = [reduced(hit, sys.argv[3]) for hit in hits]
print("equal" if expected == [other[:5] for other in others] else "different")
print("many hits" if sum(hit[0] >= 0 for hit in hits) > len(hits) // 10 else "few hits")
print("faces:", sorted({other[5] for other in others}))
