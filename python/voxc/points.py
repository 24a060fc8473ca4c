"""Volumes as lists of voxels: in arrays, and in .npz files."""
from __future__ import annotations

import ctypes
import os
import warnings
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np

from . import _library as c
from ._errors import InputError

if TYPE_CHECKING:
    from .volume import Volume


class Points(NamedTuple):
    """Voxels that are not empty, in Morton order. `voxc.build(format, places=points.places, colours=points.colours)` builds the same."""

    places: np.ndarray
    """int32 (n, 3): x, y and z, in voxels."""
    colours: np.ndarray
    """uint8 (n, 4): red, green, blue and alpha; or, of labels, uint32 (n,)."""


def points_of(volume: Volume, words: bool) -> Points:
    places, values = np.empty((volume.voxels, 3), np.int32), np.empty(volume.voxels, "<u4")
    c.check(c.lib.voxc_volume_list(volume._handle, places.ctypes.data, values.ctypes.data))
    # A word without alpha is a label, which bytes would have for empty.
    if words or (values < 1 << 24).any():
        return Points(places, values)
    return Points(places, values.view(np.uint8).reshape(-1, 4))


def save_npz(volume: Volume, path: Union[str, os.PathLike]) -> None:
    points = points_of(volume, words=True)
    np.savez_compressed(path, places=points.places, words=points.colours, extent=np.array(volume.extent, np.int32),
                        to_model=volume.to_model, format=np.array(volume.ir))


def load_npz(path: Union[str, os.PathLike], format: Optional[str] = None, **options: Any) -> Volume:
    """The volume that `Volume.save_npz` wrote, in its own format or in another; options are those of `voxc.build`. Its voxels are whole numbers
    of the model: where the file says otherwise, that is an InputWarning. Attributes are in no such file."""
    from .building import build
    from .told import InputWarning

    with np.load(path, allow_pickle=False) as file:
        missing = {"places", "words", "extent", "format"} - set(file.files)
        if missing:
            raise InputError(f"'{os.fspath(path)}' was not written by save_npz, for it has no {' and no '.join(sorted(missing))}; "
                             "voxc.build takes arrays of other files, with grid= to choose one")
        if "to_model" in file.files and not np.array_equal(file["to_model"], np.eye(3, 4)):
            warnings.warn(f"'{os.fspath(path)}' has the place of its voxels in a model, to_model, which a volume of a list has not", InputWarning,
                          stacklevel=2)
        words = str(file["format"]) if format is None else format
        return build(words, places=file["places"], colours=file["words"], extent=file["extent"].tolist(), **options)
