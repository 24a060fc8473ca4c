"""The visible faces of voxels, merged to rectangles. NumPy alone, so that it can be tried without Blender."""
import numpy as np


def colours_of(points):
    """The colours of a list of voxels as uint8 (n, 4); labels are shown in the colours that voxc gives them in pictures."""
    if points.colours.dtype == np.uint8:
        return points.colours
    labels, places = np.unique(points.colours, return_inverse=True)
    hues = labels * 0.6180339887498949 % 1
    least = np.array([0.25, 0.4, 0.1])[labels % 3]
    shares = [np.clip(np.abs((hues + third / 3) % 1 * 6 - 3) - 1, 0, 1) for third in range(3)]
    channels = [np.floor(255 * (least + (0.95 - least) * share) + 0.5) for share in shares]
    return np.stack([*channels, np.full(len(labels), 255)], axis=-1).astype(np.uint8)[places]


def rectangles_of(places, colours):
    """The faces between a voxel and an empty cell, those of one plane and one colour merged along two axes. Returns corners, int32 (n, 4, 3)
    in voxels, counterclockwise as seen from outside, and colours, uint8 (n, 4)."""
    places = np.asarray(places, np.int64).reshape(-1, 3)
    words = np.ascontiguousarray(colours, np.uint8).reshape(-1, 4).view("<u4")[:, 0]
    if len(places) == 0:
        return np.empty((0, 4, 3), np.int32), np.empty((0, 4), np.uint8)
    # A number for each cell, with an empty one beside each end of an axis, so that no neighbour is that of the row before.
    sizes = places.max(axis=0) + 3
    strides = np.array([1, sizes[0], sizes[0] * sizes[1]])
    cells = (places + 1) @ strides
    known = np.sort(cells)
    made = [_of_side(places, words, ~_among(known, cells + side * strides[axis]), axis, side) for axis in range(3) for side in (-1, 1)]
    corners, words = (np.concatenate(parts) for parts in zip(*made))
    return corners, words.view(np.uint8).reshape(-1, 4)


def _among(known, cells):
    found = np.searchsorted(known, cells)
    return known[np.minimum(found, len(known) - 1)] == cells


def _of_side(places, words, is_open, axis, side):
    u_axis, v_axis = (axis + 1) % 3, (axis + 2) % 3
    plane, u, v, word = places[is_open, axis], places[is_open, u_axis], places[is_open, v_axis], words[is_open]
    # Neighbours along u become rows, then rows that lie side by side along v rectangles.
    (plane, v, word), u, width = _runs((plane, v, word), u, order=(u, v, plane))
    (plane, u, width, word), v, height = _runs((plane, u, width, word), v, order=(v, word, width, u, plane))
    corners = np.empty((len(plane), 4, 3), np.int32)
    corners[:, :, axis] = (plane + (side > 0))[:, None]
    around = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for corner, (right, up) in enumerate(around if side > 0 else around[::-1]):
        corners[:, corner, u_axis] = u + right * width
        corners[:, corner, v_axis] = v + up * height
    return corners, word


def _runs(same, along, order):
    """Merges elements that are equal in all of `same` and follow each other in `along`; returns what each run has of `same`, where it begins, and how long it is."""
    sorting = np.lexsort(order)
    same, along = [values[sorting] for values in same], along[sorting]
    begins = np.ones(len(along), bool)
    if len(along):
        begins[1:] = along[1:] != along[:-1] + 1
    for values in same:
        begins[1:] |= values[1:] != values[:-1]
    first = np.flatnonzero(begins)
    return [values[first] for values in same], along[first], np.diff(np.append(first, len(along)))
