"""Volumes in notebooks: a picture with what is to know, and the page on which one moves through a volume."""
from __future__ import annotations

import base64
import html
import os
import pathlib
import tempfile
from typing import TYPE_CHECKING, Optional, Union

from ._program import run

if TYPE_CHECKING:
    from .volume import Volume


class Page:
    """A page that shows a volume in any browser, by the words of the volume and the kernel that traces them. In a notebook it is shown
    where it is the value of a cell."""

    def __init__(self, text: str) -> None:
        self.text = text

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes it as a file, which needs no other."""
        pathlib.Path(path).write_text(self.text, encoding="utf-8")

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="480" style="border:0"></iframe>'


def page_of(volume: Volume, title: Optional[str]) -> Page:
    with tempfile.TemporaryDirectory() as scratch:
        file, page = pathlib.Path(scratch) / "volume.hvx", pathlib.Path(scratch) / "page.html"
        volume.save(file)
        run(["export", str(file), "-o", str(page), "--quiet", "--title", title or volume.format])
        return Page(page.read_text(encoding="utf-8"))


def picture_html(volume: Volume, png: Optional[bytes]) -> str:
    """A picture, if there is one, beside a table."""
    rows = {"format": volume.format, "extent": " × ".join(map(str, volume.extent)), "voxels": f"{volume.voxels:,}",
            "bytes": f"{volume.bytes:,}"}
    if volume.voxels:
        rows["bits a voxel"] = f"{8 * volume.bytes / volume.voxels:.2f}"
    table = "".join(f"<tr><th style='text-align:left'>{name}</th><td>{html.escape(value)}</td></tr>" for name, value in rows.items())
    image = "" if png is None else f"<img alt='the volume' width='480' src='data:image/png;base64,{base64.b64encode(png).decode()}'>"
    return f"<div style='display:flex;gap:1em;align-items:center'>{image}<table>{table}</table></div>"
