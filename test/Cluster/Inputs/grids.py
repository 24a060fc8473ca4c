"""Writes two arrays, of which one has a blank in its name: grids.py FILE.npz"""
import io
import struct
import sys
import zipfile


def npy(values, shape):
    head = str({"descr": "|u1", "fortran_order": False, "shape": shape}).encode()
    head += b" " * (63 - (10 + len(head)) % 64) + b"\n"
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head + bytes(values)


with zipfile.ZipFile(sys.argv[1], "w") as archive:
    archive.writestr("my.npy", npy([1] * 343, (7, 7, 7)))
    archive.writestr("my grid.npy", npy([2] * 64, (4, 4, 4)))
