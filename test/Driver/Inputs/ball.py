"""Writes a ball as a scan of 128 x 128 x 40 samples that are 1 x 1 x 3 mm apart: as ball.nii or ball.nrrd, or with
--hollow as a shell with a small ball in it; with --corner one corner only, low in x and y, high in z."""
import struct
import sys

WIDE, HIGH, DEEP = 128, 128, 40
SPACING = (1.0, 1.0, 3.0)


def sample(x, y, z, kind):
    """255 within 56.4 mm of the middle; a shell is 6 mm thick, and what is in it is 100."""
    square = (x + 0.5 - 64) ** 2 + (y + 0.5 - 64) ** 2 + ((z - 20) * 3) ** 2
    if kind == "--corner":
        return 255 if x < 32 and y < 32 and z >= 30 else 0
    if kind == "--hollow" and square < 49 ** 2:
        return 100 if square < 20 ** 2 else 0
    return 255 if square < 56.4 ** 2 else 0


path = sys.argv[1]
samples = bytes(sample(x, y, z, sys.argv[-1]) for z in range(DEEP) for y in range(HIGH) for x in range(WIDE))
with open(path, "wb") as file:
    if path.endswith(".nii"):
        header = bytearray(352)
        struct.pack_into("<i", header, 0, 348)
        struct.pack_into("<8h", header, 40, 3, WIDE, HIGH, DEEP, 1, 1, 1, 1)
        struct.pack_into("<hh", header, 70, 2, 8)  # uint8
        struct.pack_into("<8f", header, 76, 1, *SPACING, 0, 0, 0, 0)
        struct.pack_into("<f", header, 108, 352)
        header[123] = 2  # mm
        struct.pack_into("<hh", header, 252, 0, 1)  # The affine of the scanner's rows:
        for row, spacing in enumerate(SPACING):
            line = [0.0, 0.0, 0.0, 10.0 * row]
            line[row] = spacing
            struct.pack_into("<4f", header, 280 + 16 * row, *line)
        header[344:348] = b"n+1\0"
        file.write(header)
    else:
        file.write(b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: %d %d %d\nencoding: raw\n"
                   b"space: right-anterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,3)\n\n" % (WIDE, HIGH, DEEP))
    file.write(samples)
