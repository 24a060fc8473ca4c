"""Where in a picture (OpenEXR, whose alpha is the share of a pixel that was hit) something is to be seen: the box of
it in pixels, its sides, and the least margin in hundredths of the frame."""
import struct
import sys


def alpha_of(path):
    """The width, the height and the alphas of a plain OpenEXR file, row by row."""
    with open(path, "rb") as file:
        data = file.read()
    at, attributes = 8, {}
    while data[at]:
        name, _, rest = data[at:].split(b"\0", 2)
        at = len(data) - len(rest)
        size, = struct.unpack_from("<I", data, at)
        attributes[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    offsets = struct.unpack_from(f"<{height}Q", data, at + 1)
    # A is the first channel.
    return width, height, [struct.unpack_from(f"<{width}f", data, offset + 8) for offset in offsets]


def box_of(width, height, alpha):
    rows = [y for y in range(height) if any(alpha[y])]
    columns = [x for x in range(width) if any(row[x] for row in alpha)]
    return columns[0], rows[0], columns[-1], rows[-1]


if __name__ == "__main__":
    for path in sys.argv[1:]:
        width, height, alpha = alpha_of(path)
        left, top, right, bottom = box_of(width, height, alpha)
        margin = min(left / width, top / height, (width - 1 - right) / width, (height - 1 - bottom) / height)
        wide, high = right - left + 1, bottom - top + 1
        print(f"columns {left} to {right}, rows {top} to {bottom}, {wide} x {high}, "
              f"{'within' if margin >= 0.01 else 'CUT OFF'}, round to {100 * abs(wide - high) / max(wide, high):.1f} %, "
              f"margin {100 * margin:.1f} %")
