"""Writes rays with and without bounds, and reads hits of version 2: ray-bounds.py write FOLDER, or read FILE."""
import struct
import sys
from pathlib import Path


def write(folder):
    rays = [((-4, 16.5, 16.5), (1, 0, 0), bounds) for bounds in ((0, 100), (0, 3.5), (5.5, 100), (5.5, 5.75), (float("nan"), 9))]
    header = b"VOXCRAYS" + struct.pack("<IIQ", 2, 32, len(rays))
    records = b"".join(struct.pack("<8f", *o, low, *d, high) for o, d, (low, high) in rays)
    (folder / "two.bin").write_bytes(header + records)
    (folder / "one.bin").write_bytes(b"".join(struct.pack("<6f", *o, *d) for o, d, _ in rays))
    (folder / "short.bin").write_bytes(header + records[:-1])
    (folder / "later.bin").write_bytes(b"VOXCRAYS" + struct.pack("<IIQ", 7, 32, len(rays)) + records)
    (folder / "claims.bin").write_bytes(b"VOXCRAYS" + struct.pack("<IIQ", 2, 32, 1 << 62) + records)


def read(path):
    data = path.read_bytes()
    magic, version, record, count = struct.unpack_from("<8sIIQ", data)
    print(magic.decode(), version, record, count, len(data) - 24 == record * count)
    for i in range(count):
        x, y, z, rgba, t, face, nx, ny, nz, steps = struct.unpack_from("<3iIfI3fI", data, 24 + record * i)
        print(f"({x}, {y}, {z}) {rgba:08x} t={t:g} face={face} normal=({nx:g}, {ny:g}, {nz:g}) counted={steps > 0}")


{"write": write, "read": read}[sys.argv[1]](Path(sys.argv[2]))
