#!/usr/bin/env python3
"""Small files that follow a convention of their format to the letter: conventions.py FOLDER"""
import struct
import sys
from pathlib import Path

folder = Path(sys.argv[1])


def las(levels):
    """LAS 1.2: points in a row, whose grey is a byte times 256."""
    head = bytearray(227)
    struct.pack_into("<4s", head, 0, b"LASF")
    struct.pack_into("<BB", head, 24, 1, 2)
    struct.pack_into("<HII", head, 94, 227, 227, 0)
    struct.pack_into("<BHI", head, 104, 2, 26, len(levels))
    struct.pack_into("<6d", head, 131, 1, 1, 1, 0, 0, 0)
    return bytes(head) + b"".join(struct.pack("<3iH6x3H", i, 0, 0, 0, *[level * 256] * 3) for i, level in enumerate(levels))


def ply(properties, rows, kinds):
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}", *(f"property {each}" for each in properties), "end_header\n"]
    return "\n".join(lines).encode() + b"".join(struct.pack("<" + kinds, *row) for row in rows)


def tiff(extra, pixels):
    """A page of RGBA bytes, whose alpha is associated (1) or not (2)."""
    size = len(pixels) // 4
    tags = [(256, 3, 1, size), (257, 3, 1, 1), (258, 3, 4, 8), (259, 3, 1, 1), (262, 3, 1, 2), (273, 4, 1, 16), (277, 3, 1, 4),
            (278, 3, 1, 1), (279, 4, 1, len(pixels)), (338, 3, 1, extra)]
    bits = 8
    data = struct.pack("<4H", 8, 8, 8, 8) + pixels
    place = 8 + len(data)
    entries = b"".join(struct.pack("<HHII", tag, kind, count, bits if tag == 258 else value) for tag, kind, count, value in tags)
    return struct.pack("<2sHI", b"II", 42, place) + data + struct.pack("<H", len(tags)) + entries + bytes(4)


def vox(size, cells):
    def chunk(name, content):
        return name + struct.pack("<ii", len(content), 0) + content
    model = chunk(b"SIZE", struct.pack("<3i", *size)) + chunk(b"XYZI", struct.pack("<i", len(cells)) + b"".join(bytes((*cell, 1)) for cell in cells))
    return b"VOX " + struct.pack("<i", 150) + b"MAIN" + struct.pack("<ii", 0, len(model)) + model


floats = ["float x", "float y", "float z"]
(folder / "white.las").write_bytes(las([255, 200, 128, 1]))
(folder / "packed.ply").write_bytes(ply([*floats, "float rgb"], [(0, 0, 0, 0x008a1020), (3, 0, 0, 0xff8a1020)], "3fI"))
(folder / "associated.tif").write_bytes(tiff(1, bytes((128, 0, 0, 128, 255, 0, 0, 255))))
(folder / "other.tif").write_bytes(tiff(2, bytes((255, 0, 0, 128, 255, 0, 0, 255))))
(folder / "tower.vox").write_bytes(vox((2, 2, 8), [(x, y, z) for x in range(2) for y in range(2) for z in range(8)]))
(folder / "labels.raw").write_bytes(struct.pack("<8I", 0, 1, 2, 3, 4, 5, 6, 7))
