"""Pictures: arrays of pixels, and PNG files of them without any library but Python's own."""
from __future__ import annotations

import os
import struct
import zlib
from typing import Any, Optional, Union

import numpy as np


class Picture(np.ndarray):
    """Pixels (height, width, 4) of uint8: an array as any other, which a notebook shows."""

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes it as a PNG file."""
        save_picture(path, self)

    def _repr_png_(self) -> Optional[bytes]:
        # Parts of it and what is computed of it may be no pictures.
        return png_of(self) if self.dtype == np.uint8 and self.ndim == 3 and self.shape[2] in (3, 4) and self.size else None


def save_picture(path: Union[str, os.PathLike], pixels: Any) -> None:
    """Writes an array (height, width, 3 or 4) of uint8 as a PNG file, whose name ends in .png."""
    if not os.fspath(path).lower().endswith(".png"):
        raise ValueError(f"pictures are written as PNG, and '{os.fspath(path)}' does not end in .png")
    data = png_of(pixels)
    with open(path, "wb") as file:
        file.write(data)


def png_of(pixels: Any) -> bytes:
    """The bytes of a PNG file."""
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
    written = [b"\x89PNG\r\n\x1a\n"]
    for name, data in (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0)),
        (b"IDAT", zlib.compress(rows.tobytes(), 6)),
        (b"IEND", b""),
    ):
        written.append(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))
    return b"".join(written)
