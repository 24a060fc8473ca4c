# rays.py write FILE: two rays along +x; rays.py read FILE: prints the hits of a file.
import struct
import sys

mode, path = sys.argv[1:]
if mode == "write":
    with open(path, "wb") as file:
        file.write(struct.pack("<6f", -5, 1.5, 2.5, 1, 0, 0))
        file.write(struct.pack("<6f", -5, 9.5, 2.5, 1, 0, 0))
else:
    with open(path, "rb") as file:
        for x, y, z, rgba, t, steps in struct.iter_unpack("<iiiIfI", file.read()):
            print(f"{x} {y} {z} {rgba:08x} t={t} steps={steps}")
