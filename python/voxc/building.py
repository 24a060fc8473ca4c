"""Building volumes from arrays, functions and files."""
import ctypes

from . import _library as c
from . import arrays
from .format import Format
from .volume import Volume


INPUT_OPTIONS = ("resolution", "coverage", "z_up", "threshold", "colour_map")


def build(format, input=None, *, voxels=None, labels=None, greys=None, densities=None, threshold=None, window=None, places=None,
          colours=None, voxel=None, is_empty=None, extent=None, passes=None, threads=None, memory_bytes=None, path=None,
          compress=False, progress=None, **input_options):
    """Builds a volume in a format (a Format, or a text and `passes`). Its voxels come from one of

    input    a file: a mesh, points, .vox, a dense volume, "builtin:terrain"; options are resolution, coverage, z_up,
             threshold and colour_map, as of the tools
    voxels   an array [z, y, x]: uint32 words, bool, or uint8 of shape (z, y, x, 4) or (z, y, x, 3) for RGBA and RGB, where
             an alpha of 0 is empty; of RGB, black is
    labels   whole numbers [z, y, x] from 0, which is empty, to 65535: the words of the volume, as of the colour map "labels"
    greys    uint8 [z, y, x]; 0 is empty
    densities  numbers [z, y, x], of which those from `threshold` up are voxels, as greys over `window`
    places   whole numbers (n, 3) of x, y, z, with `colours`, which is (n,) words or (n, 4) uint8; the last at a place counts
    voxel    a function of x, y, z that returns a word, with `extent` and, if it is known, `is_empty` of x, y, z, side

    What cannot be kept as it is raises ValueError: nothing is cast or left out in silence.

    With `path` the volume is written to that file while it is built. `progress` is called with a stage, a fraction and a
    number now and then; what it raises ends the build.
    """
    if sum(given is not None for given in (input, voxels, labels, greys, densities, places, voxel)) != 1:
        raise TypeError("build takes one of input, voxels, labels, greys, densities, places and voxel")
    for name in input_options:
        if name not in INPUT_OPTIONS:
            raise TypeError(f"build has no option {name}; those of files are {', '.join(INPUT_OPTIONS)}")
        if input is None:
            raise TypeError(f"{name} is for files alone")
    if threshold is not None and input is None and densities is None:
        raise TypeError("threshold is for files and densities")
    if window is not None and densities is None:
        raise TypeError("window is for densities")
    made = format if isinstance(format, Format) else Format(format, passes)
    reporter = c.Reporter(progress)
    options = c.options(c.BuildOptions, threads=threads, memory_bytes=memory_bytes, path=c.text(path),
                        compress=int(compress), progress=reporter.pointer)
    volume = ctypes.c_void_p()
    last = ctypes.byref(options), ctypes.byref(volume)
    if input is not None:
        error = c.lib.voxc_build_input(made._handle, c.text(input), ctypes.byref(_input(threshold=threshold, **input_options)),
                                       *last)
    elif places is not None:
        error = _build_places(made, places, colours, extent, last)
    elif voxel is None:
        words = _grid(voxels, labels, greys, densities, threshold, window)
        size = (ctypes.c_int32 * 3)(*words.shape[::-1])
        error = c.lib.voxc_build_grid(made._handle, words.ctypes.data, size, *last)
    else:
        asked = c.VOXEL(reporter.guard(lambda _, x, y, z: arrays.word_of(voxel(x, y, z))))
        source = c.Source((ctypes.c_int32 * 3)(*extent), asked,
                          c.IS_EMPTY(reporter.guard(lambda _, *cube: bool(is_empty and is_empty(*cube)))), None)
        error = c.lib.voxc_build_source(made._handle, ctypes.byref(source), *last)
    reporter.check(error)
    built = Volume(volume)
    reporter.check_failure()
    return built


def _grid(voxels, labels, greys, densities, threshold, window):
    if voxels is not None:
        return arrays.grid_of(voxels)
    if labels is not None:
        return arrays.labels_of(labels)
    return arrays.greys_of(greys) if greys is not None else arrays.densities_of(densities, threshold, window)


def _input(resolution=None, coverage=None, z_up=None, threshold=None, colour_map=None):
    least = None if threshold is None else ctypes.pointer(ctypes.c_double(threshold))
    up = None if z_up is None else 1 if z_up else -1
    return c.options(c.InputOptions, resolution=resolution, coverage=c.text(coverage), z_up=up, threshold=least,
                     colour_map=c.text(colour_map))


def _build_places(made, places, colours, extent, last):
    places = arrays.places_of(places)
    words = arrays.colours_of(colours, len(places))
    size = None if extent is None else (ctypes.c_int32 * 3)(*extent)
    return c.lib.voxc_build_voxels(made._handle, places.ctypes.data, words.ctypes.data, len(places), size, *last)
