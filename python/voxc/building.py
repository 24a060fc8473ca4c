"""Building volumes from arrays, functions and files."""
from __future__ import annotations

import ctypes
import inspect
import os
from typing import Any, Callable, Iterable, Optional, Sequence, Tuple, Union

import numpy as np

from . import _library as c
from . import arrays
from ._names import refuse_unknown
from .automatic import build_automatic
from .format import Format
from .told import Told
from .volume import Volume


INPUT_OPTIONS = ("resolution", "voxel_size", "unit", "align", "bounds", "z_up", "coverage", "colour", "colour_map", "volume", "grid",
                 "interior", "fill_colour", "crop")


def build(format: Union[str, Format], input: Union[str, os.PathLike, None] = None, *, voxels: Any = None, labels: Any = None,
          greys: Any = None, densities: Any = None, threshold: Optional[float] = None, window: Optional[Tuple[float, float]] = None,
          places: Any = None, colours: Any = None, voxel: Optional[Callable[[int, int, int], int]] = None,
          is_empty: Optional[Callable[[int, int, int, int], bool]] = None, extent: Optional[Sequence[int]] = None,
          passes: Union[str, Iterable[str], None] = None, threads: Optional[int] = None, memory_bytes: Optional[int] = None,
          path: Union[str, os.PathLike, None] = None, compress: bool = False, progress: Any = None, **input_options: Any) -> Volume:
    """Builds a volume in a format (a Format, or a text and `passes`). Its voxels come from one of

    input    a file: a mesh, points, .vox, a dense volume, "builtin:terrain"; options are those of `voxc build`: resolution,
             voxel_size (0.5 or "0.5mm"), unit, align (x, y, z), bounds (x0, y0, z0, x1, y1, z1), z_up, coverage, colour,
             threshold, colour_map, window (low, high), volume, grid, interior, fill_colour and crop. What is left out of
             the file is an InputWarning each, and among the `warnings` of the volume, beside its `notes`
    voxels   an array [z, y, x]: uint32 words, bool, or uint8 of shape (z, y, x, 4) or (z, y, x, 3) for RGBA and RGB, where
             an alpha of 0 is empty; of RGB, black is
    labels   whole numbers [z, y, x] from 0, which is empty, to 65535: the words of the volume, as of the colour map "labels"
    greys    uint8 [z, y, x]; 0 is empty
    densities  numbers [z, y, x], of which those from `threshold` up are voxels, as greys over `window`
    places   whole numbers (n, 3) of x, y, z, with `colours`, which is (n,) words or (n, 4) uint8; the last at a place counts
    voxel    a function of x, y, z that returns a word, with `extent` and, if it is known, `is_empty` of x, y, z, side

    Arrays may be of NumPy, or of others that share memory by DLPack or the array interface, as those of torch and jax on the CPU.
    What cannot be kept as it is raises ValueError: nothing is cast or left out in silence.

    With the format "auto" it is the one that `voxc suggest` names, and the program voxc builds it, without `progress`.

    With `path` the volume is written to that file while it is built. `progress` is called with a stage, a fraction and a
    number now and then; what it raises ends the build. A bar of tqdm's will do in its place. `threads` of None are all of the machine.
    """
    if sum(given is not None for given in (input, voxels, labels, greys, densities, places, voxel)) != 1:
        raise TypeError("build takes one of input, voxels, labels, greys, densities, places and voxel")
    refuse_unknown("build", input_options, OPTIONS)
    meant = {"threshold": (threshold, input is not None or densities is not None, "files and densities"),
             "window": (window, input is not None or densities is not None, "files and densities"),
             "colours": (colours, places is not None, "places"),
             "extent": (extent, places is not None or voxel is not None, "places and functions"),
             "is_empty": (is_empty, voxel is not None, "functions"),
             "passes": (passes, not isinstance(format, Format), "formats that are texts"),
             "compress": (compress or None, path is not None, "a path")}
    meant.update({name: (value, input is not None, "files alone") for name, value in input_options.items()})
    for name, (value, applies, what) in meant.items():
        if value is not None and not applies:
            raise TypeError(f"{name} is for {what}")
    if isinstance(format, str) and format.strip() == "auto":
        if passes is not None or progress is not None:
            raise TypeError("passes and progress are for a format that is named")
        given = dict(voxels=voxels, labels=labels, greys=greys, densities=densities, window=window, places=places, colours=colours,
                     voxel=voxel, is_empty=is_empty, extent=extent)
        input_options.update(window=window if input is not None else None, threads=threads, memory=memory_bytes)
        return build_automatic(build, input, given, threshold, path, compress, input_options)
    made = format if isinstance(format, Format) else Format(format, passes)
    reporter = c.Reporter(progress)
    if voxel is not None and threads is None:
        threads = 1  # A function of Python runs on one at a time.
    options = c.options(c.BuildOptions, threads=threads, memory_bytes=memory_bytes, path=c.text(path),
                        compress=int(compress), progress=reporter.pointer)
    volume = ctypes.c_void_p()
    told = Told()
    result = Volume(volume, told)
    last = ctypes.byref(options), ctypes.byref(volume)
    if input is not None:
        read = input_options_of(told, threshold=threshold, window=window, **input_options)
        try:
            reporter.call(c.lib.voxc_build_input, made._handle, c.needed(input, "an input"), ctypes.byref(read), *last)
        finally:
            told.warn(2)
    elif places is not None:
        _build_places(reporter, made, places, colours, extent, last)
    elif voxel is None:
        words = _grid(voxels, labels, greys, densities, threshold, window)
        size = (ctypes.c_int32 * 3)(*words.shape[::-1])
        reporter.call(c.lib.voxc_build_grid, made._handle, words.ctypes.data, size, *last)
    else:
        asked = c.VOXEL(reporter.guard(lambda _, x, y, z: arrays.word_of(voxel(x, y, z))))
        source = c.Source(c.int3(extent, "extent"), asked,
                          c.IS_EMPTY(reporter.guard(lambda _, *cube: bool(is_empty and is_empty(*cube)))), None)
        reporter.call(c.lib.voxc_build_source, made._handle, ctypes.byref(source), *last)
    return result


OPTIONS = tuple(name for name in inspect.signature(build).parameters if name not in ("format", "input_options")) + INPUT_OPTIONS


def _grid(voxels, labels, greys, densities, threshold, window):
    """Words [z, y, x] in the order of C, which is the library's, whatever the order of what was given."""
    if voxels is not None:
        words = arrays.grid_of(voxels)
    elif labels is not None:
        words = arrays.labels_of(labels)
    else:
        words = arrays.greys_of(greys) if greys is not None else arrays.densities_of(densities, threshold, window)
    return np.ascontiguousarray(words, np.uint32)


def input_options_of(told, resolution=None, volume=None, z_up=None, threshold=None, crop=None, align=None, bounds=None, window=None,
           voxel_size=None, **texts):
    least = None if threshold is None else ctypes.pointer(ctypes.c_double(threshold))
    up = None if z_up is None else 1 if z_up else -1
    size = None if voxel_size is None else str(voxel_size)
    return c.options(c.InputOptions, resolution=resolution, volume=volume, z_up=up, threshold=least, crop=None if crop is None else int(crop),
                     align=_numbers(align, 3, "align"), bounds=_numbers(bounds, 6, "bounds"), window=_numbers(window, 2, "window"),
                     voxel_size=c.text(size), report=ctypes.pointer(told.report), **{name: c.text(text) for name, text in texts.items()})


def _numbers(values, count, what):
    """So many numbers as an array of C; None stays None."""
    if values is None:
        return None
    if len(values) != count:
        raise ValueError(f"{what} is {count} numbers, not {values}")
    return (ctypes.c_double * count)(*values)


def _build_places(reporter, made, places, colours, extent, last):
    places = arrays.places_of(places)
    words = arrays.colours_of(colours, len(places))
    size = None if extent is None else c.int3(extent, "extent")
    reporter.call(c.lib.voxc_build_voxels, made._handle, places.ctypes.data, words.ctypes.data, len(places), size, *last)
