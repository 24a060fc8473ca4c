# Reads the pictures of examples: PNG files of 8 bits a channel.
import struct
import zlib


class Picture:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        chunks, at = {}, 8
        while at < len(data):
            (length,) = struct.unpack_from(">I", data, at)
            kind = data[at + 4 : at + 8]
            chunks[kind] = chunks.get(kind, b"") + data[at + 8 : at + 8 + length]
            at += 12 + length
        self.width, self.height, depth, colour = struct.unpack_from(">IIBB", chunks[b"IHDR"])
        self.channels = {2: 3, 6: 4}[colour]
        assert depth == 8
        self.rows = list(self.unfilter(zlib.decompress(chunks[b"IDAT"])))

    def unfilter(self, raw):
        step, size = self.channels, self.channels * self.width
        above = bytearray(size)
        for y in range(self.height):
            kind, row = raw[y * (size + 1)], bytearray(raw[y * (size + 1) + 1 : (y + 1) * (size + 1)])
            for i in range(size):
                a = row[i - step] if i >= step else 0
                b, c = above[i], above[i - step] if i >= step else 0
                paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
                row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 0xFF
            yield row
            above = row

    def mean(self, left, top, right, bottom):
        """The mean red, green and blue of a box of pixels."""
        pixels = [
            self.rows[y][self.channels * x : self.channels * x + 3] for y in range(top, bottom) for x in range(left, right)
        ]
        return [sum(channel) / len(pixels) for channel in zip(*pixels)]

    def expect(self, name, box, holds):
        colour = self.mean(*box)
        assert holds(*colour), (name, colour)
