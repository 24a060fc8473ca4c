"""Volumes."""
from __future__ import annotations

import builtins
import ctypes
import os
from typing import Any, Iterator, Optional, Sequence, Tuple, Union

import numpy as np

from . import _library as c
from ._names import refuse_unknown
from .arrays import elements_of
from .page import Page, page_of, picture_html
from .picture import Picture, png_of
from .points import Points, points_of, save_npz
from .tracer import RENDER_OPTIONS, TRACER_OPTIONS, Tracer

Path = Union[str, os.PathLike]


class Volume:
    """A volume, which never changes. `voxc.build` makes one, `Volume.load` opens a .hvx file."""

    def __init__(self, handle: Any, told: Any = None) -> None:
        self._handle = handle
        self._told = told
        self._png: Optional[builtins.bytes] = None

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            c.lib.voxc_volume_free(self._handle)

    @classmethod
    def load(cls, path: Path, trusted: bool = False, threads: Optional[int] = None, frame: int = 0) -> Volume:
        """Opens a .hvx file. `trusted` leaves out the proof that every offset in it is right. `frame`, from 1 on: this frame
        of an animation alone; 0: the first, beside all others."""
        options = c.options(c.LoadOptions, trusted=int(trusted), threads=threads, frame=frame)
        return cls(c.make(c.lib.voxc_volume_load, c.needed(path, "a path"), ctypes.byref(options)))

    def save(self, path: Path, compress: bool = False) -> None:
        """Writes a .hvx file; one that was there stays until the new one is whole."""
        c.check(c.lib.voxc_volume_save(self._handle, c.needed(path, "a path"), int(compress)))

    @property
    def format(self) -> str:
        """Its format in short, without its passes: "R(4, 4, 4) G(5)"."""
        return c.lib.voxc_volume_format(self._handle).decode()

    @property
    def frames(self) -> int:
        """How many frames it has, of which it shows the first; 1 if it is no animation."""
        return c.lib.voxc_volume_frames(self._handle)

    @property
    def ir(self) -> str:
        """Its format as IR text, with all that passes decided: what `voxc.build` takes for another volume of the same."""
        return c.lib.voxc_volume_ir(self._handle).decode()

    @property
    def digest(self) -> int:
        """The digest of its format's storage, a number of 64 bits: emitted functions are for this volume if theirs,
        VOXC_..._STORAGE_DIGEST, is the same."""
        return c.lib.voxc_volume_digest(self._handle)

    @property
    def warnings(self) -> Tuple[str, ...]:
        """What of the file that it was built from was left out, or taken otherwise than it may be meant: sentences."""
        return tuple(self._told.warnings) if self._told else ()

    @property
    def notes(self) -> Tuple[str, ...]:
        """What was done with that file as asked for, or by default: sentences."""
        return tuple(self._told.notes) if self._told else ()

    @property
    def provenance(self) -> str:
        """How it was made, as "name=value" with blanks between."""
        return c.lib.voxc_volume_provenance(self._handle).decode()

    @property
    def extent(self) -> Tuple[int, ...]:
        """Voxels along (x, y, z)."""
        extent = (ctypes.c_int32 * 3)()
        c.lib.voxc_volume_extent(self._handle, extent)
        return tuple(extent)

    @property
    def voxels(self) -> int:
        """How many are not empty."""
        return c.lib.voxc_volume_voxels(self._handle)

    @property
    def bytes(self) -> int:
        """What all its streams take."""
        return c.lib.voxc_volume_bytes(self._handle)

    @property
    def words(self) -> np.ndarray:
        """What kernels read, as an array that cannot be written."""
        count = ctypes.c_uint64()
        first = c.lib.voxc_volume_words(self._handle, ctypes.byref(count))
        words = np.frombuffer(c.memory_of(self, ctypes.cast(first, ctypes.c_void_p).value, 4 * count.value), np.uint32)
        words.flags.writeable = False
        return words

    def attribute(self, name: str) -> np.ndarray:
        """The elements of an attribute as rows of bytes [voxel, byte], by the numbers of the voxels; `.view("<f4")` and the
        like make numbers of them. KeyError where there is none."""
        size = ctypes.c_uint32()
        first = c.lib.voxc_volume_attribute(self._handle, c.needed(name, "a name"), ctypes.byref(size))
        if size.value == 0:
            raise KeyError(name)
        shape = (self.voxels, size.value)
        if self.voxels == 0:
            return np.empty(shape, np.uint8)
        address = ctypes.cast(first, ctypes.c_void_p).value
        elements = np.frombuffer(c.memory_of(self, address, self.voxels * size.value), np.uint8).reshape(shape)
        elements.flags.writeable = False
        return elements

    def with_attribute(self, name: str, elements: Any) -> Volume:
        """The same volume with an attribute more: an array whose first axis is that of the voxels, by
        their numbers."""
        elements = elements_of(elements, self.voxels)
        size = elements.itemsize * int(np.prod(elements.shape[1:]))
        return Volume(c.make(c.lib.voxc_volume_with_attribute, self._handle, c.needed(name, "a name"), size, elements.ctypes.data))

    @property
    def to_model(self) -> np.ndarray:
        """The matrix from voxels to the units of the model, (3, 4)."""
        rows = np.zeros(12)
        c.lib.voxc_volume_to_model(self._handle, rows.ctypes.data_as(ctypes.POINTER(ctypes.c_double)))
        return rows.reshape(3, 4)

    def read(self, low: Sequence[int] = (0, 0, 0), size: Optional[Sequence[int]] = None) -> np.ndarray:
        """The words of a box of voxels as an array [z, y, x]; `low` and `size` are of x, y and z. Without `size`: all that
        is behind `low`."""
        first = c.int3(low, "low")
        sides = c.int3([end - begin for begin, end in zip(first, self.extent)] if size is None else size, "size")
        if min(sides) < 0:
            raise ValueError(f"a box has sizes from 0 up, not {tuple(sides)}")
        words = np.empty(tuple(sides)[::-1], np.uint32)
        c.check(c.lib.voxc_volume_read(self._handle, first, sides, words.ctypes.data))
        return words

    def points(self, words: bool = False) -> Points:
        """Its voxels that are not empty as (places, colours), in Morton order: int32 (n, 3) of x, y, z, and uint8 (n, 4) of red, green,
        blue and alpha, or, of labels and with `words`, uint32 (n,). `voxc.build` takes the same as `places=` and `colours=`."""
        return points_of(self, words)

    def chunks(self, side: int = 64) -> Iterator[Tuple[Tuple[int, int, int], np.ndarray]]:
        """Its boxes of `side` voxels an axis that are not empty, as (low, words): the place of the first voxel, (x, y, z), and what
        `read` gives of the box, cut at the end of the volume. One is in memory at a time."""
        ends = self.extent
        if side < 1:
            raise ValueError(f"chunks have 1 voxel an axis or more, not {side}")
        for z, y, x in np.ndindex(*(-(-end // side) for end in reversed(ends))):
            low = (x * side, y * side, z * side)
            words = self.read(low, [min(side, end - begin) for begin, end in zip(low, ends)])
            if words.any():
                yield low, words

    def save_npz(self, path: Path) -> None:
        """Writes places, words, extent and format as an .npz file, which `voxc.load_npz` and NumPy read."""
        save_npz(self, path)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> np.ndarray:
        """All of it as an array [z, y, x] of words, for numpy.asarray and those who take arrays."""
        if copy is False:
            raise ValueError("the words of a volume are decoded, so an array of them is always a copy")
        return self.read() if dtype is None else self.read().astype(dtype, copy=False)

    def tracer(self, device: Optional[str] = None, **options: Any) -> Tracer:
        """A Tracer of this volume."""
        refuse_unknown("tracer", options, TRACER_OPTIONS)
        return Tracer(self, device, **options)

    def trace(self, origins: Any, directions: Any = None, device: Optional[str] = None, *, tmin: Any = None, tmax: Any = None,
              **options: Any) -> np.ndarray:
        """The hits of rays, once: `Tracer.trace` of a new tracer, for those who trace no more than this."""
        refuse_unknown("trace", options, TRACER_OPTIONS)
        is_bounded = tmin is not None or tmax is not None
        return self.tracer(device, bounds=is_bounded, **options).trace(origins, directions, tmin, tmax)

    def render(self, width: int = 1280, height: int = 720, device: Optional[str] = None, **options: Any) -> Picture:
        """A picture, once: `Tracer.render` of a new tracer."""
        refuse_unknown("render", options, RENDER_OPTIONS)
        return self.tracer(device).render(width, height, **options)

    def page(self, title: Optional[str] = None) -> Page:
        """A page on which one moves through it in any browser (docs/web-page.md), made by the program voxc."""
        return page_of(self, title)

    def _repr_png_(self) -> Optional[builtins.bytes]:
        if self.voxels == 0:
            return None
        if self._png is None:
            self._png = png_of(self.render(480, 320, device="cpu"))
        return self._png

    def _repr_html_(self) -> str:
        return picture_html(self, self._repr_png_())

    def __repr__(self) -> str:
        extent = " x ".join(map(str, self.extent))
        return f"<voxc.Volume of {self.voxels} voxels in {extent}, {self.bytes} bytes>"
