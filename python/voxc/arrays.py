"""Arrays as the library takes them. What cannot be kept as it is, is a ValueError that says what would be right."""
import math

import numpy as np

ALPHA = np.uint32(0xFF000000)
SOLID = np.uint32(0xFFFFFFFF)
MOST_LABEL = 0xFFFF
INT32 = np.iinfo(np.int32)
CPU = 1  # As DLPack numbers devices.


def array_of(given, what):
    """An array as it is, of NumPy or of another library on this processor. One that says of some elements that they have no value
    is none."""
    if isinstance(given, np.ma.MaskedArray):
        raise ValueError(f"{what} are a masked array, whose masked elements have no value; filled(0) gives them one")
    if hasattr(given, "__dlpack_device__") and not isinstance(given, np.ndarray) and given.__dlpack_device__()[0] != CPU:
        raise ValueError(f"{what} lie in the memory of another device; .cpu() of torch and .get() of CuPy bring them here")
    if not hasattr(given, "__array__") and hasattr(given, "__dlpack__") and hasattr(np, "from_dlpack"):
        return np.from_dlpack(given)
    return np.asarray(given)


def grid_of(voxels):
    """The words [z, y, x] of voxels that are words, bool, or bytes of RGBA or RGB."""
    voxels = array_of(voxels, "voxels")
    if voxels.ndim == 4:
        words = bytes_as_words(voxels)
        check_axes(words)
        return words
    check_axes(voxels)
    if voxels.dtype == bool:
        return np.where(voxels, SOLID, np.uint32(0))
    return as_words(voxels)


def labels_of(labels):
    """Words that are labels: whole numbers from 0, which is empty, to 65535."""
    labels = array_of(labels, "labels")
    check_axes(labels)
    if labels.dtype.kind not in "iub":
        raise ValueError(f"labels are whole numbers, not {labels.dtype}; labels.astype('uint16') makes them so")
    check_range(labels, 0, MOST_LABEL, "labels")
    return labels.astype(np.uint32)


def greys_of(greys):
    """Words of greys from 0, which is empty, to 255."""
    greys = array_of(greys, "greys")
    check_axes(greys)
    if greys.dtype != np.uint8:
        raise ValueError(f"greys are uint8, not {greys.dtype}; densities= takes other numbers, with a threshold")
    words = greys.astype(np.uint32)
    return np.where(words != 0, words * np.uint32(0x010101) | ALPHA, np.uint32(0))


def densities_of(densities, threshold, window=None):
    """Words of what is dense: numbers from `threshold` up, as greys from black to white over `window`, or over what there is."""
    densities = array_of(densities, "densities")
    check_axes(densities)
    if densities.dtype.kind not in "iuf":
        raise ValueError(f"densities are numbers, not {densities.dtype}")
    if threshold is None or not np.isfinite(threshold):
        raise ValueError("densities need a threshold, a number from which on they are voxels")
    if densities.dtype.kind == "f" and not np.isfinite(densities).all():
        raise ValueError("some densities are no number (NaN) or infinite; numpy.nan_to_num makes them finite")
    if densities.dtype.kind == "f":
        densities = densities.astype(np.float64)  # NumPy 1 would round the threshold to the type of the densities.
    solid = densities >= (threshold if densities.dtype.kind == "f" else math.ceil(threshold))  # Whole numbers may have more digits.
    if not solid.any():
        raise ValueError(f"no density reaches the threshold {threshold}; they are {densities.min()} to {densities.max()}")
    low, high = (float(threshold), float(densities.max())) if window is None else ends_of(window)
    scaled = (np.clip(densities.astype(np.float64), low, high) - low) / (high - low if high > low else 1)
    grey = np.rint(scaled * 255).astype(np.uint32)
    return np.where(solid, grey * np.uint32(0x010101) | ALPHA, np.uint32(0))


def ends_of(window):
    """The two ends of a window of densities."""
    ends = [float(end) for end in window]
    if len(ends) != 2 or not np.isfinite(ends).all() or ends[0] > ends[1]:
        raise ValueError(f"a window is two numbers, of which the first is the lower one, and not {window}")
    return ends


def places_of(places):
    """Whole numbers x, y, z of n voxels as int32 (n, 3)."""
    places = array_of(places, "places")
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"places are x, y, z of n voxels, (n, 3), not of the shape {places.shape}")
    if places.dtype.kind not in "iuf":
        raise ValueError(f"places are whole numbers, not {places.dtype}")
    if places.dtype.kind == "f" and not np.array_equal(places, np.trunc(places)):
        raise ValueError("places are whole numbers, and some of these are not; numpy.floor takes the voxel around a point")
    check_range(places, INT32.min, INT32.max, "places")
    return np.ascontiguousarray(places, dtype=np.int32)


def colours_of(colours, count):
    """A word for each of so many voxels: white, words, or bytes of RGBA or RGB."""
    if colours is None:
        return np.full(count, SOLID, np.uint32)
    colours = array_of(colours, "colours")
    words = np.ascontiguousarray(bytes_as_words(colours) if colours.ndim == 2 else as_words(colours))
    if words.ndim != 1:
        raise ValueError(f"colours are one word for each of n voxels, (n,), or bytes (n, 4) or (n, 3), not of the shape {colours.shape}")
    if len(words) != count:
        raise ValueError(f"there are {count} places, but {len(words)} colours")
    return words


def as_words(numbers):
    """Whole numbers that are words, R in the low byte and alpha in the high one."""
    if numbers.dtype.kind == "u" and numbers.itemsize == 4:
        return numbers.astype(np.uint32, copy=False)  # In the order of this machine's bytes.
    if numbers.dtype.kind == "f":
        raise ValueError(f"words are uint32, not {numbers.dtype}; densities= takes such numbers, with a threshold")
    if numbers.dtype.kind not in "iu":
        raise ValueError(f"words are uint32, not {numbers.dtype}")
    check_range(numbers, 0, 0xFFFFFFFF, "words")
    if np.any((numbers != 0) & (numbers < 1 << 24)):
        raise ValueError(f"numbers below 2^24 of {numbers.dtype} are no colours, as they have no alpha; labels= takes labels, greys= greys, "
                         "and words of any value are uint32")
    return numbers.astype(np.uint32)


def word_of(number):
    """One word, as a function of the coordinates returns it; True is white."""
    if isinstance(number, (bool, np.bool_)):
        return int(SOLID) if number else 0
    if not 0 <= number <= 0xFFFFFFFF or number != int(number):
        raise ValueError(f"a voxel is a word from 0 to {0xFFFFFFFF}, not {number}")
    return int(number)


def bytes_as_words(colours):
    """RGBA or RGB bytes as words; those of no alpha, or black without one, are empty."""
    if colours.dtype != np.uint8 or colours.shape[-1] not in (3, 4):
        raise ValueError(f"colours are uint8 with 3 or 4 channels, not {colours.dtype} of the shape {colours.shape}")
    words = np.zeros(colours.shape[:-1], np.uint32)
    for channel in range(3):
        words |= colours[..., channel].astype(np.uint32) << np.uint32(8 * channel)
    if colours.shape[-1] == 3:
        return np.where(words != 0, words | ALPHA, np.uint32(0))
    alpha = colours[..., 3].astype(np.uint32)
    return np.where(alpha != 0, words | alpha << np.uint32(24), np.uint32(0))


def rays_of(origins, directions):
    """Origins and directions as float32, of one shape (..., 3)."""
    pair = []
    for what, given in (("origins", origins), ("directions", directions)):
        array = array_of(given, what)
        if array.dtype.kind not in "iuf":
            raise ValueError(f"{what} are numbers, not {array.dtype}")
        if array.shape[-1:] != (3,):
            raise ValueError(f"{what} have three numbers each, (..., 3), and not the shape {array.shape}")
        pair.append(array.astype(np.float32))
    try:
        return np.broadcast_arrays(*pair)
    except ValueError:
        raise ValueError(f"origins of the shape {pair[0].shape} and directions of the shape {pair[1].shape} do not fit together: "
                         "give as many of both, or one for all") from None


def bounds_of(bounds, shape, what):
    """Numbers that are one for all rays, or one for each."""
    array = array_of(bounds, what)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{what} is a number for all rays or one for each, not {array.dtype}")
    try:
        return np.broadcast_to(array, shape)
    except ValueError:
        raise ValueError(f"{what} is a number for all rays or one for each; it has the shape {array.shape}, and the rays {shape}") from None


def elements_of(elements, count):
    """The elements of an attribute, one for each voxel, in little-endian bytes."""
    elements = array_of(elements, "elements")
    if elements.dtype.hasobject or elements.dtype.kind in "OUSMm":
        raise ValueError(f"elements of an attribute are numbers or structures of them, not {elements.dtype}")
    if elements.ndim == 0 or len(elements) != count:
        raise ValueError(f"there are {elements.shape[0] if elements.ndim else 'no'} elements, but {count} voxels")
    return np.ascontiguousarray(elements, dtype=elements.dtype.newbyteorder("<"))


def check_axes(voxels):
    if voxels.ndim != 3:
        raise ValueError(f"a grid of voxels is indexed [z, y, x], but this array has the shape {voxels.shape}")
    if voxels.size == 0:
        raise ValueError(f"a grid has at least one voxel an axis, and this array has the shape {voxels.shape}")


def check_range(numbers, least, most, what):
    if numbers.size and (numbers.min() < least or numbers.max() > most):
        raise ValueError(f"{what} are from {least} to {most}, and these from {numbers.min()} to {numbers.max()}")
