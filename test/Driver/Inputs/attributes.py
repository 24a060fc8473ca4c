# attributes.py FOLDER [check]: rays from the walls of a box of 16 voxels, and elements for its voxels; then what stands at
# the numbers of hits, beside their colours.
import sys

import numpy

folder = sys.argv[1]
HIT = numpy.dtype([("voxel", "<i4", 3), ("rgba", "<u4"), ("t", "<f4"), ("steps", "<u4")])


def stream(path, name):
    """A stream of a file of version 2, by its table of streams."""
    data = open(path, "rb").read()
    for row in range(int.from_bytes(data[68:72], "little")):
        at = 168 + 56 * row
        if data[at:at + 32].rstrip(b"\0").decode() == name:
            elements, offset = (int.from_bytes(data[at + i:at + i + 8], "little") for i in (40, 48))
            return numpy.frombuffer(data, "<u4", elements, offset)
    raise SystemExit(f"no stream {name}")


if len(sys.argv) == 2:
    random = numpy.random.default_rng(7)
    rays = numpy.concatenate([random.uniform(0, 16, (4000, 3)), random.normal(size=(4000, 3))], axis=1)
    rays.astype("<f4").tofile(folder + "/rays.bin")
    voxels = len(stream(folder + "/more.hvx", "colour"))
    numpy.arange(voxels, dtype="<u2").tofile(folder + "/weights.bin")
else:
    colours, numbers = (numpy.fromfile(folder + name, HIT) for name in ("/colours.bin", "/numbers.bin"))
    hit = colours["voxel"][:, 0] >= 0
    assert (colours["voxel"] == numbers["voxel"]).all() and (colours["t"] == numbers["t"]).all()
    same = stream(folder + "/more.hvx", "colour")[numbers["rgba"][hit]] == colours["rgba"][hit]
    print(f"{hit.sum()} hits, {same.sum()} of the colour that stands at their number")
