"""compare.py NAME HITS: every answer of examples/engine is that of `voxc trace` for the undivided volume, bit for bit, where no triangle is
nearer, and the octahedron's where one is. NAME.rays and NAME.hits are the engine's; HITS are those of voxc."""
import struct
import sys

MIDDLE, REACH = (60, 84, 52), 30  # As in Scene.h.
ROUNDING = 0.05                    # Of a driver's triangles, in voxels; rays are at most 300 long.


def octahedron(origin, direction):
    """Where a ray enters the octahedron |x| + |y| + |z| <= REACH and where it leaves it, by its eight planes; None where it passes by."""
    origin = [o - m for o, m in zip(origin, MIDDLE)]
    begin, end = 0.0, float("inf")
    for octant in range(8):
        signs = [1 if octant >> axis & 1 else -1 for axis in range(3)]
        gap = REACH - sum(s * o for s, o in zip(signs, origin))
        speed = sum(s * d for s, d in zip(signs, direction))
        if speed == 0 and gap < 0:
            return None
        if speed < 0:
            begin = max(begin, gap / speed)
        elif speed > 0:
            end = min(end, gap / speed)
    return (begin, end) if begin <= end else None


name, hits = sys.argv[1:]
rays = list(struct.iter_unpack("<6f", open(name + ".rays", "rb").read()))
engine = list(struct.iter_unpack("<iiiIfI", open(name + ".hits", "rb").read()))
voxels = list(struct.iter_unpack("<iiiIfI", open(hits, "rb").read()))
assert len(rays) == len(engine) == len(voxels) > 0, (len(rays), len(engine), len(voxels))
counts = [0, 0, 0]
for number, (ray, found, wanted) in enumerate(zip(rays, engine, voxels)):
    kind, t = found[5], found[4]
    counts[kind] += 1
    through = octahedron(ray[:3], ray[3:])
    if kind == 2:  # The octahedron, before any voxel; at its very outline rounding decides.
        assert through or octahedron([o + ROUNDING for o in ray[:3]], ray[3:]) or octahedron([o - ROUNDING for o in ray[:3]], ray[3:]), (number, found)
        assert not through or abs(t - through[0]) <= ROUNDING, (number, found, through)
        assert wanted[0] < 0 or wanted[4] >= t, (number, found, wanted)
        continue
    assert found[:5] == wanted[:5], (number, found, wanted)
    if through and through[1] - through[0] > ROUNDING:
        assert kind == 1 and through[0] >= t - ROUNDING, (number, found, through)
print("%d rays: %d voxels, bit for bit, %d triangles, %d of neither" % (len(rays), counts[1], counts[2], counts[0]))
