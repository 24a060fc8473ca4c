#!/usr/bin/env python3
"""An animation of MagicaVoxel, and its voxels frame by frame: animation.py write FILE.vox, or animation.py check VOXC V.hvx [FRAME].

A ball of 7 voxels rolls over a floor of 24 x 20, and becomes smaller in the last frame. `check` compares the voxels of frames of a
volume that voxc built of the file with what stands here.
"""
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

FLOOR = (24, 20, 2)
PLACES = [(-8, -5, 5), (-4, -2, 5), (0, 1, 5), (4, 4, 5), (8, 4, 6)]  # Of the ball's middle; +z is up.
SIDES = [7, 7, 7, 7, 5]
COLOURS = {1: (200, 80, 40), 2: (60, 120, 60)}


def ball(side):
    half = side // 2
    cells = range(-half, half + 1)
    return {(x, y, z) for x in cells for y in cells for z in cells if x * x + y * y + z * z <= half * half}


def words(*numbers):
    return struct.pack(f"<{len(numbers)}i", *numbers)


def text(string):
    return words(len(string)) + string.encode()


def pairs(**entries):
    return words(len(entries)) + b"".join(text(key) + text(value) for key, value in entries.items())


def chunk(name, content):
    return name.encode() + words(len(content), 0) + content


def model(size, voxels):
    cells = b"".join(bytes((*cell, colour)) for cell, colour in voxels)
    return chunk("SIZE", words(*size)) + chunk("XYZI", words(len(voxels)) + cells)


def moved(number, child, places):
    frames = b"".join(pairs(_f=str(i), _t=" ".join(map(str, place))) for i, place in enumerate(places))
    return chunk("nTRN", words(number) + pairs() + words(child, -1, -1, len(places)) + frames)


def shape(number, models):
    """`models`: number by the frame from which on it is seen."""
    entries = b"".join(words(model) + pairs(_f=str(frame)) for frame, model in models.items())
    return chunk("nSHP", words(number) + pairs() + words(len(models)) + entries)


def file_bytes():
    floor = [((x, y, z), 2) for z in range(FLOOR[2]) for y in range(FLOOR[1]) for x in range(FLOOR[0])]
    models = model(FLOOR, floor)
    for side in (7, 5):
        half = side // 2
        models += model((side,) * 3, [((x + half, y + half, z + half), 1) for x, y, z in sorted(ball(side))])
    graph = moved(0, 1, [(0, 0, 0)]) + chunk("nGRP", words(1) + pairs() + words(2, 2, 4))
    graph += moved(2, 3, [(0, 0, 1)]) + shape(3, {0: 0})
    graph += moved(4, 5, PLACES) + shape(5, {0: 1, len(PLACES) - 1: 2})
    palette = b"".join(bytes((*COLOURS.get(i + 1, (0, 0, 0)), 255)) for i in range(256))
    chunks = models + graph + chunk("RGBA", palette)
    return b"VOX " + words(150) + b"MAIN" + words(0, len(chunks)) + chunks


def scene(frame):
    """Colours by cell, in the axes of MagicaVoxel."""
    cells = {(x - FLOOR[0] // 2, y - FLOOR[1] // 2, z): 2 for x in range(FLOOR[0]) for y in range(FLOOR[1]) for z in range(FLOOR[2])}
    at = PLACES[frame]
    cells.update({tuple(a + b for a, b in zip(cell, at)): 1 for cell in ball(SIDES[frame])})
    return cells


def expected(frame):
    """The same as voxc has them: +y is up, and the box of all frames begins at 0."""
    all_cells = [cell for other in range(len(PLACES)) for cell in scene(other)]
    low = [min(cell[axis] for cell in all_cells) for axis in range(3)]
    far = max(cell[1] for cell in all_cells)
    return {(x - low[0], z - low[2], far - y): COLOURS[colour] for (x, y, z), colour in scene(frame).items()}


def voxels_of(voxc, volume, frame):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "voxels.ply"
        subprocess.run([voxc, "export", volume, "--frame", str(frame + 1), "-o", path, "--quiet"], check=True)
        head, body = path.read_bytes().split(b"end_header\n", 1)
    count = int(head.split(b"element vertex ")[1].split()[0])
    rows = struct.iter_unpack("<3i4B", body)
    found = {row[:3]: row[3:6] for row in rows}
    assert len(found) == count, (len(found), count)
    return found


if sys.argv[1] == "write":
    Path(sys.argv[2]).write_bytes(file_bytes())
else:
    _, _, program, volume, *chosen = sys.argv
    for frame in [int(chosen[0]) - 1] if chosen else range(len(PLACES)):
        found, wanted = voxels_of(program, volume, frame), expected(frame)
        assert found == wanted, f"frame {frame + 1}: {len(found.items() ^ wanted.items())} voxels are others"
        print(f"frame {frame + 1}: {len(found)} voxels")
