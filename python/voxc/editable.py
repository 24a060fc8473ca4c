"""Volumes that change."""
from __future__ import annotations

import ctypes
import os
import threading
from typing import Any, Callable, List, Optional, Sequence, Union

import numpy as np

from . import _library as c
from . import arrays
from ._turns import in_turn
from .volume import Volume


class Snapshot:
    """A state of an `Editable`, to come back to with `restore` or to look at with `view`."""

    def __init__(self, owner: Editable, state: Any) -> None:
        self._owner = owner
        self._state = state

    @property
    def voxels(self) -> int:
        """How many are not empty."""
        return self._state.voxels


class Editable:
    """A volume that changes in place: `Editable(volume)`. An edit takes the time that its own voxels ask for, whatever the
    size of the volume. Words are as everywhere: 0 is empty, else RGBA8 with R in the low byte. Of several threads that use
    one, each waits for the others.

    Raises `voxc.Error` for a format that cannot be edited, and says what stands against it."""

    def __init__(self, volume: Volume) -> None:
        self._lock = threading.RLock()
        self._is_applying = False
        self._handle = c.make(c.lib.voxc_editable_create, c.handle_of(volume, Volume, "what is edited"))

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            c.lib.voxc_editable_free(self._handle)

    @in_turn
    def set_box(self, low: Sequence[int], size: Sequence[int], word: int) -> None:
        """Voxels [low, low + size) become `word`; 0 clears them."""
        self._begin_edit()
        c.check(c.lib.voxc_editable_set_box(self._handle, c.int3(low, "low"), c.int3(size, "size"), arrays.word_of(word)))

    @in_turn
    def set_sphere(self, centre: Sequence[int], radius: int, word: int) -> None:
        """Voxels whose centre is no farther than `radius` voxels, a whole number, from that of the voxel `centre` become `word`."""
        if not 0 <= radius <= 2**20 or radius != int(radius):
            raise ValueError(f"the radius of a sphere is a whole number from 0 to {2**20}, not {radius}")
        self._begin_edit()
        c.check(c.lib.voxc_editable_set_sphere(self._handle, c.int3(centre, "centre"), int(radius), arrays.word_of(word)))

    @in_turn
    def set_voxels(self, places: Any, words: Any) -> None:
        """Single voxels: places (N, 3) of x, y, z, and N words or colours as `voxc.build` takes them, or one word for all. Of
        several at one place the last counts."""
        places = arrays.places_of(places)
        if np.ndim(words) == 0:
            words = np.full(len(places), arrays.word_of(words), np.uint32)
        else:
            words = arrays.colours_of(words, len(places))
        self._begin_edit()
        c.check(c.lib.voxc_editable_set_voxels(self._handle, places.ctypes.data, words.ctypes.data, len(places)))

    @in_turn
    def paste(self, volume: Volume, low: Sequence[int] = (0, 0, 0)) -> None:
        """Puts the voxels of another volume from `low` on; where it is empty nothing changes."""
        self._begin_edit()
        c.check(c.lib.voxc_editable_paste(self._handle, c.handle_of(volume, Volume, "what is pasted"), c.int3(low, "low")))

    def clear(self, low: Sequence[int], size: Sequence[int]) -> None:
        """Empties the voxels [low, low + size)."""
        self.set_box(low, size, 0)

    @in_turn
    def apply(self, low: Sequence[int], size: Sequence[int], function: Callable[[int, int, int, int], int]) -> None:
        """Each voxel of a box becomes what `function(x, y, z, word)` says of it, which must not edit this volume itself,
        nor use a `Tracer` with a picture whose progress uses this volume: each would wait for the other."""
        raised: list = []

        def voxel(_: Any, x: int, y: int, z: int, word: int) -> int:
            try:
                return word if raised else arrays.word_of(function(x, y, z, word))
            except BaseException as error:  # noqa: BLE001 - it goes on behind the library.
                raised.append(error)
                return word

        before = self.snapshot()
        self._begin_edit()
        self._is_applying = True
        try:
            c.check(c.lib.voxc_editable_apply(self._handle, c.int3(low, "low"), c.int3(size, "size"), c.EDITED_VOXEL(voxel), None))
        finally:
            self._is_applying = False
        if raised:
            self.restore(before)
            raise raised[0]

    def _begin_edit(self) -> None:
        if self._is_applying:
            raise RuntimeError("an edit of this volume is running, whose function must not edit it")

    @in_turn
    def snapshot(self) -> Snapshot:
        """The state now, which costs nothing."""
        return Snapshot(self, c.lib.voxc_editable_snapshot(self._handle))

    @in_turn
    def restore(self, snapshot: Snapshot) -> None:
        """Makes a state that of the volume again, be it older or newer: undo and redo."""
        if snapshot._owner is not self:
            raise ValueError("the snapshot is of another volume")
        self._begin_edit()
        c.lib.voxc_editable_restore(self._handle, snapshot._state)

    @in_turn
    def view(self, snapshot: Optional[Snapshot] = None) -> Volume:
        """A state, or that of now, as a Volume, which stays what it is while edits go on."""
        if snapshot is not None and snapshot._owner is not self:
            raise ValueError("the snapshot is of another volume")
        state = (snapshot or self.snapshot())._state
        return Volume(c.make(c.lib.voxc_editable_view, self._handle, state))

    @property
    @in_turn
    def frames(self) -> List[Snapshot]:
        """The frames of the animation that it began with; none if it was none."""
        count = c.lib.voxc_editable_frames(self._handle, None, 0)
        states = (c.Snapshot * count)()
        c.lib.voxc_editable_frames(self._handle, states, count)
        return [Snapshot(self, state) for state in states]

    @in_turn
    def framed(self, frames: Sequence[Snapshot]) -> Volume:
        """A Volume whose frames are these states; `save` writes all of them, and it shows the first."""
        if any(frame._owner is not self for frame in frames):
            raise ValueError("a frame is of another volume")
        states = (c.Snapshot * len(frames))(*(frame._state for frame in frames))
        return Volume(c.make(c.lib.voxc_editable_framed, self._handle, states, len(frames)))

    @in_turn
    def compact(self, path: Union[str, os.PathLike, None] = None, compress: bool = False) -> Volume:
        """The Volume of the voxels as they are, by a build: the words are those of any build of them. With `path` it is
        written there."""
        options = c.options(c.BuildOptions, path=c.text(path) if path is not None else None, compress=int(compress))
        return Volume(c.make(c.lib.voxc_editable_compact, self._handle, ctypes.byref(options)))

    @property
    @in_turn
    def voxels(self) -> int:
        """How many are not empty."""
        return c.lib.voxc_editable_voxels(self._handle)

    @property
    @in_turn
    def words(self) -> int:
        """How many words all states have together."""
        return c.lib.voxc_editable_words(self._handle)

    @property
    @in_turn
    def wants_compaction(self) -> bool:
        """True if these are more than half as many again as those of the first volume."""
        return bool(c.lib.voxc_editable_wants_compaction(self._handle))

    def __repr__(self) -> str:
        return f"<voxc.Editable of {self.voxels} voxels, {4 * self.words} bytes>"
