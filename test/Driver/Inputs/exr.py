"""Reads a plain OpenEXR file by the format's layout, and says what is in it."""
import struct
import sys

data = open(sys.argv[1], "rb").read()
magic, version = struct.unpack_from("<II", data)
assert magic == 20000630 and version == 2
at, attributes = 8, {}
while data[at]:
    name, kind, rest = data[at:].split(b"\0", 2)
    at += len(name) + len(kind) + 2
    (size,) = struct.unpack_from("<I", data, at)
    attributes[name.decode()] = data[at + 4:at + 4 + size]
    at += 4 + size
at += 1
left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
width, height = right - left + 1, bottom - top + 1
channels, list_ = [], attributes["channels"]
while list_[0]:
    name, list_ = list_.split(b"\0", 1)
    assert struct.unpack_from("<I", list_) == (2,)
    channels.append(name.decode())
    list_ = list_[16:]
planes = {name: [] for name in channels}
for row, offset in enumerate(struct.unpack_from(f"<{height}Q", data, at)):
    assert struct.unpack_from("<iI", data, offset) == (row, width * len(channels) * 4)
    for i, name in enumerate(channels):
        planes[name] += struct.unpack_from(f"<{width}f", data, offset + 8 + i * width * 4)
assert offset + 8 + width * len(channels) * 4 == len(data)
alpha = planes["A"]
print(f"{width} x {height}, channels {' '.join(channels)}, alpha from {min(alpha):g} to {max(alpha):g}, "
      f"light up to {max(planes['R']):g}")
