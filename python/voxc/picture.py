"""Writing pictures without any library but Python's own."""
import os
import struct
import zlib

import numpy as np


def save_picture(path, pixels):
    """Writes an array (height, width, 3 or 4) of uint8 as a PNG file, whose name ends in .png."""
    if not os.fspath(path).lower().endswith(".png"):
        raise ValueError(f"pictures are written as PNG, and '{os.fspath(path)}' does not end in .png")
    pixels = np.asarray(pixels)
    if pixels.dtype != np.uint8:
        raise ValueError(f"pixels are uint8, not {pixels.dtype}")
    pixels = np.ascontiguousarray(pixels)
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4):
        raise ValueError(f"a picture has rows, columns and 3 or 4 channels, not the shape {pixels.shape}")
    height, width, channels = pixels.shape
    colour_type = 2 if channels == 3 else 6
    rows = np.zeros((height, 1 + width * channels), np.uint8)  # Each row begins with its filter, of which 0 is none.
    rows[:, 1:] = pixels.reshape(height, -1)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, data in (
            (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0)),
            (b"IDAT", zlib.compress(rows.tobytes(), 6)),
            (b"IEND", b""),
        ):
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))
