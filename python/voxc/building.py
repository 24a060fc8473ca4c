"""Building volumes from arrays, functions and files."""
import ctypes

import numpy as np

from . import _library as c
from .format import Format
from .volume import Volume


def build(format, input=None, *, voxels=None, places=None, colours=None, voxel=None, is_empty=None, extent=None,
          passes=None, threads=None, memory_bytes=None, path=None, compress=False, progress=None, **input_options):
    """Builds a volume in a format (a Format, or a text and `passes`). Its voxels come from one of

    input    a file: a mesh, points, .vox, a dense volume, "builtin:terrain"; options are resolution, coverage, z_up,
             threshold and colour_map, as of the tools
    voxels   an array [z, y, x]: uint32 words, bool, or uint8 of shape (z, y, x, 4) or (z, y, x, 3) for RGBA and RGB, where
             an alpha of 0 is empty; of RGB, black is
    places   an int array (n, 3) of x, y, z, with `colours`, which is (n,) words or (n, 4) uint8; the last at a place counts
    voxel    a function of x, y, z that returns a word, with `extent` and, if it is known, `is_empty` of x, y, z, side

    With `path` the volume is written to that file while it is built. `progress` is called with a stage, a fraction and a
    number now and then; what it raises ends the build.
    """
    if sum(given is not None for given in (input, voxels, places, voxel)) != 1:
        raise TypeError("build takes one of input, voxels, places and voxel")
    if input_options and input is None:
        raise TypeError(f"{next(iter(input_options))} is for files alone")
    made = format if isinstance(format, Format) else Format(format, passes)
    reporter = c.Reporter(progress)
    options = c.options(c.BuildOptions, threads=threads, memory_bytes=memory_bytes, path=c.text(path),
                        compress=int(compress), progress=reporter.pointer)
    volume = ctypes.c_void_p()
    last = ctypes.byref(options), ctypes.byref(volume)
    if input is not None:
        error = c.lib.voxc_build_input(made._handle, c.text(input), ctypes.byref(_input(**input_options)), *last)
    elif voxels is not None:
        words = _grid(voxels)
        size = (ctypes.c_int32 * 3)(*words.shape[::-1])
        error = c.lib.voxc_build_grid(made._handle, words.ctypes.data, size, *last)
    elif places is not None:
        error = _build_places(made, places, colours, extent, last)
    else:
        source = c.Source((ctypes.c_int32 * 3)(*extent), c.VOXEL(lambda _, x, y, z: int(voxel(x, y, z))),
                          c.IS_EMPTY(lambda _, *cube: bool(is_empty and is_empty(*cube))), None)
        error = c.lib.voxc_build_source(made._handle, ctypes.byref(source), *last)
    reporter.check(error)
    return Volume(volume)


def _input(resolution=None, coverage=None, z_up=None, threshold=None, colour_map=None):
    least = None if threshold is None else ctypes.pointer(ctypes.c_double(threshold))
    up = None if z_up is None else 1 if z_up else -1
    return c.options(c.InputOptions, resolution=resolution, coverage=c.text(coverage), z_up=up, threshold=least,
                     colour_map=c.text(colour_map))


def _grid(voxels):
    voxels = np.asarray(voxels)
    if voxels.ndim == 4:
        return _words(voxels)
    if voxels.ndim != 3:
        raise ValueError(f"a grid of voxels is indexed [z, y, x], but this array has the shape {voxels.shape}")
    if voxels.dtype == bool:
        return np.where(voxels, np.uint32(0xFFFFFFFF), np.uint32(0))
    return np.ascontiguousarray(voxels, dtype=np.uint32)


def _words(colours):
    """RGBA or RGB bytes as words; those of no alpha, or black without one, are empty."""
    colours = np.asarray(colours)
    if colours.dtype != np.uint8 or colours.shape[-1] not in (3, 4):
        raise ValueError(f"colours are uint8 with 3 or 4 channels, not {colours.dtype} of the shape {colours.shape}")
    words = np.zeros(colours.shape[:-1], np.uint32)
    for channel in range(3):
        words |= colours[..., channel].astype(np.uint32) << np.uint32(8 * channel)
    if colours.shape[-1] == 3:
        return np.where(words != 0, words | np.uint32(0xFF000000), np.uint32(0))
    alpha = colours[..., 3].astype(np.uint32)
    return np.where(alpha != 0, words | alpha << np.uint32(24), np.uint32(0))


def _build_places(made, places, colours, extent, last):
    places = np.ascontiguousarray(places, dtype=np.int32)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"places are x, y, z of n voxels, (n, 3), not of the shape {places.shape}")
    words = np.full(len(places), 0xFFFFFFFF, np.uint32) if colours is None else np.asarray(colours)
    words = np.ascontiguousarray(_words(words) if words.ndim == 2 else words, dtype=np.uint32)
    if len(words) != len(places):
        raise ValueError(f"there are {len(places)} places, but {len(words)} colours")
    size = None if extent is None else (ctypes.c_int32 * 3)(*extent)
    return c.lib.voxc_build_voxels(made._handle, places.ctypes.data, words.ctypes.data, len(places), size, *last)
