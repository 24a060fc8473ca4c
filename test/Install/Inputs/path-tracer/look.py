# Looks at a picture of the hall: the sky is blue, the sponge is gold with a bright lamp in it, and the red wall is red.
import struct
import sys
import zlib

with open(sys.argv[1], "rb") as file:
    data = file.read()
assert data[:8] == b"\x89PNG\r\n\x1a\n"
chunks, at = {}, 8
while at < len(data):
    (length,) = struct.unpack_from(">I", data, at)
    kind = data[at + 4 : at + 8]
    chunks[kind] = chunks.get(kind, b"") + data[at + 8 : at + 8 + length]
    at += 12 + length
width, height, depth, colour = struct.unpack_from(">IIBB", chunks[b"IHDR"])
assert (width, height, depth, colour) == (64, 36, 8, 2)

raw = zlib.decompress(chunks[b"IDAT"])
rows, above = [], bytearray(3 * width)
for y in range(height):
    kind, row = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1 : (y + 1) * (3 * width + 1)])
    for i in range(3 * width):
        a = row[i - 3] if i >= 3 else 0
        b, c = above[i], above[i - 3] if i >= 3 else 0
        paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 0xFF
    rows.append(row)
    above = row


def mean(left, top, right, bottom):
    pixels = [rows[y][3 * x : 3 * x + 3] for y in range(top, bottom) for x in range(left, right)]
    return [sum(channel) / len(pixels) for channel in zip(*pixels)]


for name, box, holds in (
    ("sky", (40, 2, 44, 3), lambda r, g, b: b > r and b > 100),
    ("sponge", (22, 8, 39, 27), lambda r, g, b: r > g > b and r > 1.3 * b),
    ("lamp", (28, 15, 31, 18), lambda r, g, b: r > 200),
    ("wall", (52, 10, 55, 18), lambda r, g, b: r > 2 * g and r > 2 * b),
):
    colour = mean(*box)
    assert holds(*colour), (name, colour)
