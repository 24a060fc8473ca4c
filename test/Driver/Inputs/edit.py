"""The edits of edit.test on dense grids: edit.py V.raw W.raw OUT.raw"""
import struct
import sys

SIDE, SMALL = 128, 8


def read(path):
    data = open(path, "rb").read()
    return list(struct.unpack(f"<{len(data) // 4}I", data))


def at(x, y, z):
    return x + SIDE * (y + SIDE * z)


volume, pasted = read(sys.argv[1]), read(sys.argv[2])
for z in range(64):
    for y in range(128):
        for x in range(64):
            volume[at(x, y, z)] = 0
for z in range(SMALL):
    for y in range(SMALL):
        for x in range(SMALL):
            word = pasted[x + SMALL * (y + SMALL * z)]
            if word:
                volume[at(5 + x, 6 + y, 7 + z)] = word
volume[at(5, 6, 7)] = 0xFF0080FF
volume[at(6, 6, 7)] = 0
open(sys.argv[3], "wb").write(struct.pack(f"<{len(volume)}I", *volume))
