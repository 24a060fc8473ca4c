"""Reads a compressed .hvx file as docs/hvx.md describes it, by other means than voxc: hvx_pages.py FILE

Prints for each stream its name, pages, bytes and stored bytes, and writes its decoded bytes to FILE.NAME.
"""
import struct
import subprocess
import sys

path = sys.argv[1]
data = open(path, "rb").read()
version, order = struct.unpack_from("<II", data, 8)
file_bytes, head_bytes = struct.unpack_from("<QQ", data, 24)
ir_bytes, provenance_bytes, streams = struct.unpack_from("<III", data, 60)
assert (version, order, file_bytes) == (3, 0x01020304, len(data))


def decoded(stored, room):
    if len(stored) == room:
        return stored
    return subprocess.run(["zstd", "-d", "-c"], input=stored, capture_output=True, check=True).stdout


def joined(planes, element):
    whole = len(planes) // element
    page = bytearray(planes)
    for rank in range(element):
        page[rank : whole * element : element] = planes[rank * whole : (rank + 1) * whole]
    return page


row = 168 + 56 * streams + ir_bytes + provenance_bytes
begin = head_bytes
for i in range(streams):
    name, element, page_bytes, elements, offset = struct.unpack_from("<32sIIQQ", data, 168 + 56 * i)
    name = name.rstrip(b"\0").decode()
    assert offset == begin
    left = element * elements
    content = bytearray()
    while left > 0:
        (end,) = struct.unpack_from("<Q", data, row)
        room = min(page_bytes, left)
        stored = data[begin:end]
        page = decoded(stored, room)
        assert len(page) == room
        content += page if len(stored) == room else joined(page, element)
        begin, left, row = end, left - room, row + 16
    print(name, -(-len(content) // page_bytes), len(content), begin - offset)
    open(f"{path}.{name}", "wb").write(content)
assert begin == len(data)
assert not data[row:head_bytes].strip(b"\0")
