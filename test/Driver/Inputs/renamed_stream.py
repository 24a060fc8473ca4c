"""Gives a stream of an uncompressed .hvx file another name, which voxc may refuse: renamed_stream.py FILE NAME TO"""
import ctypes
import ctypes.util
import struct
import sys

path, name, to = sys.argv[1:]
data = bytearray(open(path, "rb").read())
(streams,) = struct.unpack_from("<I", data, 68)
# The row of a stream begins with its name, as docs/hvx.md says.
rows = [row for row in range(168, 168 + 56 * streams, 56) if data[row : row + 32].rstrip(b"\0") == name.encode()]
assert len(rows) == 1
data[rows[0] : rows[0] + 32] = to.encode().ljust(32, b"\0")

checksum = ctypes.CDLL(ctypes.util.find_library("xxhash")).XXH3_64bits
checksum.restype, checksum.argtypes = ctypes.c_uint64, [ctypes.c_char_p, ctypes.c_size_t]
others = bytes(data[:16] + data[24:])
struct.pack_into("<Q", data, 16, checksum(others, len(others)))
open(path, "wb").write(data)
