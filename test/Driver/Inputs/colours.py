"""The colours of a PNG, or of several: how many there are, and the first three; with --corners the size,
and which corners are not empty: upper left and right, lower left and right."""
import struct
import sys
import zlib


def pixels_of(path):
    """The width and the rows of a PNG of 8 bits a channel, each a list of tuples."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    assert depth == 8
    raw, stride, rows, above = zlib.decompress(packed), width * channels, [], bytes(width * channels)
    for y in range(height):
        way, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            up = above[i]
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[i] = (line[i] + [0, left, up, (left + up) // 2, paeth][way]) & 255
        rows.append([tuple(line[i:i + channels]) for i in range(0, stride, channels)])
        above = line
    return width, rows


if __name__ == "__main__":
    for path in sys.argv[1:]:
        if path == "--corners":
            continue
        width, rows = pixels_of(path)
        if "--corners" in sys.argv:
            corners = [row[x][3] for row in (rows[0], rows[-1]) for x in (0, -1)]
            print(f"{width} x {len(rows)}:", "".join("#" if alpha else "." for alpha in corners))
            continue
        colours = sorted({pixel for row in rows for pixel in row})
        print(len(colours), "colour:" if len(colours) == 1 else "colours:", *(",".join(map(str, c[:3])) for c in colours[:3]))
