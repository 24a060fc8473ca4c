"""Tracing rays, and pictures of what they hit."""
from __future__ import annotations

import ctypes
import threading
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Tuple, Union

import numpy as np

from . import _library as c
from ._turns import both_in_turn, in_turn
from .arrays import bounds_of, rays_of
from .format import list_of
from .picture import Picture

if TYPE_CHECKING:
    from .editable import Editable
    from .volume import Volume

Names = Union[str, Iterable[str], None]

RAY = np.dtype([("origin", "<f4", 3), ("direction", "<f4", 3)])
"""A ray, in voxels, as it lies in files."""

BOUNDED_RAY = np.dtype([("origin", "<f4", 3), ("tmin", "<f4"), ("direction", "<f4", 3), ("tmax", "<f4")])
"""A ray with bounds: voxels are looked for that it enters at a t from tmin to tmax. The exact t counts, which is 0 where
the ray begins in the voxel."""

HIT = np.dtype([("voxel", "<i4", 3), ("rgba", "<u4"), ("t", "<f4"), ("face", "<u4")])
"""A hit: the voxel (-1, -1, -1 of a miss), its colour or label, the t at which the ray enters it, correctly rounded, and
the face, if that was asked for: twice its axis, and 1 more for the high one; 6 if the ray begins in the voxel."""


def devices() -> List[str]:
    """The names of all devices: those of Vulkan, then "cpu"."""
    count = c.lib.voxc_devices(None, 0)
    infos = (c.DeviceInfo * count)()
    count = min(c.lib.voxc_devices(infos, count), count)
    return [info.name.decode() for info in infos[:count]]


def normals(hits: np.ndarray) -> np.ndarray:
    """The normals of the faces by which rays enter their voxels, out of these, as an array (..., 3): of hits of a tracer
    whose outputs have the face. Those of misses, and where a ray begins in its voxel, are 0."""
    face = np.where(hits["voxel"][..., 0] >= 0, hits["face"], 6)
    table = np.zeros((7, 3), np.float32)
    table[np.arange(6), np.arange(6) // 2] = np.where(np.arange(6) % 2, 1, -1)
    return table[np.minimum(face, 6)]


def _rays(origins: Any, directions: Any, tmin: Any, tmax: Any) -> np.ndarray:
    """Rays as the library takes them, with bounds if there are any."""
    is_bounded = tmin is not None or tmax is not None
    if directions is None:
        kind = getattr(origins, "dtype", None)
        if kind not in (RAY, BOUNDED_RAY):
            raise ValueError("rays are origins and directions, or an array of voxc.RAY or voxc.BOUNDED_RAY alone; there are no directions")
        given = np.asarray(origins, dtype=kind, order="C")
        if not is_bounded:
            return given
        if kind == BOUNDED_RAY:
            raise ValueError("rays that have bounds take no others")
        origins, directions = given["origin"], given["direction"]
    origins, directions = rays_of(origins, directions)
    rays = np.empty(origins.shape[:-1], BOUNDED_RAY if is_bounded else RAY)
    rays["origin"], rays["direction"] = origins, directions
    if is_bounded:
        rays["tmin"] = bounds_of(0 if tmin is None else tmin, rays.shape, "tmin")
        rays["tmax"] = bounds_of(np.inf if tmax is None else tmax, rays.shape, "tmax")
    return rays


def rays_as_given(given: Any) -> np.ndarray:
    """Rays without bounds: an array of RAY, or a pair of origins and directions."""
    pair = tuple(given) if isinstance(given, (tuple, list)) else (given, None)
    if len(pair) != 2:
        raise ValueError("rays are a pair of origins and directions, or an array of voxc.RAY")
    origins, directions = pair
    rays = _rays(origins, directions, None, None)
    if rays.dtype != RAY:
        raise ValueError("these rays have no bounds: an array of voxc.RAY")
    return rays.reshape(-1)


def _point(given: Any, what: str) -> Any:
    """A point as three doubles; None stays None."""
    if given is None:
        return None
    point = np.asarray(given)
    if point.shape != (3,) or point.dtype.kind not in "iuf":
        raise ValueError(f"{what} is a point x, y, z, and not {given}")
    return (ctypes.c_double * 3)(*point)


def _clip_box(given: Any) -> Any:
    """Two corners as six doubles; None stays None."""
    if given is None:
        return None
    try:
        box = np.asarray(given)
    except ValueError:  # Of corners that are not of one length.
        box = np.empty(0)
    if box.shape not in ((6,), (2, 3)) or box.dtype.kind not in "iuf":
        raise ValueError(f"clip_box is two corners, ((x0, y0, z0), (x1, y1, z1)), and not {given}")
    return (ctypes.c_double * 6)(*box.reshape(-1))


def _clip_planes(given: Any) -> Tuple[Any, int]:
    """One plane or several as four doubles each, and how many there are."""
    if given is None:
        return None, 0
    try:
        planes = np.atleast_2d(np.asarray(given))
    except ValueError:
        planes = np.array("several lengths")
    if planes.size == 0:
        return None, 0
    if planes.ndim != 2 or planes.shape[1] != 4 or planes.dtype.kind not in "iuf":
        raise ValueError(f"clip_planes are planes (nx, ny, nz, d), and not {given}")
    return (ctypes.c_double * planes.size)(*planes.reshape(-1)), len(planes)


def _handle_of(given: Any, name: str) -> Any:
    """What the library knows a Volume or an Editable by."""
    from . import Editable, Volume

    return c.handle_of(given, {"Editable": Editable, "Volume": Volume}[name], "what is traced")


TRACER_OPTIONS = ("threads", "query", "outputs", "precision", "passes", "bounds")
RENDER_OPTIONS = ("style", "view", "eye", "look", "fov", "samples", "progress", "clip_box", "clip_planes", "orthographic", "view_height")


class Tracer:
    """Traces rays through a volume by a kernel that is compiled for it. `device` is a part of a device's name, or "cpu"; by
    default the best of Vulkan, or the cpu where there is none. `query` is "closest", "any", "occupancy" or "distance";
    `outputs` names what is stored of the closest hit, of voxel, t, face and colour; `precision` is "exact" or "fast".
    With `bounds` its one kernel is for rays with bounds; without, that is a second one, made when such rays come. Of
    several threads that use one, each waits for the others; the progress of a picture must not use it."""

    def __init__(self, volume: Volume, device: Optional[str] = None, *, threads: Optional[int] = None, query: Optional[str] = None,
                 outputs: Names = None, precision: Optional[str] = None, passes: Names = None, bounds: bool = False) -> None:
        self._lock = threading.RLock()
        self._is_rendering = False
        self._volume = volume
        self._options = dict(device=c.text(device), threads=threads, query=c.text(query), outputs=list_of(outputs),
                             precision=c.text(precision), passes=list_of(passes))
        self._handle = self._create(bounds=int(bounds))
        self._bounded_handle = self._handle if bounds else None

    def _bounded(self) -> Any:
        """The tracer for rays with bounds, which is made when it is first asked for."""
        self._bounded_handle = self._bounded_handle or self._create(bounds=1)
        return self._bounded_handle

    def _create(self, bounds: int) -> Any:
        options = c.options(c.TracerOptions, bounds=bounds, **self._options)
        return c.make(c.lib.voxc_tracer_create, _handle_of(self._volume, "Volume"), ctypes.byref(options))

    def _check_idle(self) -> None:
        if self._is_rendering:
            raise RuntimeError("a picture of this tracer is being made, whose progress must not use the tracer")

    def __del__(self) -> None:
        handles = [getattr(self, name, None) for name in ("_handle", "_bounded_handle")]
        for handle in {handle.value: handle for handle in handles if handle}.values():
            c.lib.voxc_tracer_free(handle)

    @property
    def device(self) -> str:
        """The name of the device that it traces on."""
        return c.lib.voxc_tracer_device(self._handle).decode()

    @in_turn
    def trace(self, origins: Any, directions: Any = None, tmin: Any = None, tmax: Any = None) -> np.ndarray:
        """The hits of rays: an array of HIT, of as many and in the shape of the rays. These are (..., 3) origins and
        directions, of which one may be a single one for all, or an array of RAY or BOUNDED_RAY alone. `tmin` and `tmax`,
        a number for all or one for each ray, are the bounds between which voxels are looked for; the kernel for rays
        with bounds is compiled when it is first asked for."""
        self._check_idle()
        rays = _rays(origins, directions, tmin, tmax)
        hits = np.zeros(rays.shape, HIT)
        if rays.dtype == RAY:
            function, handle = c.lib.voxc_tracer_trace, self._handle
        else:
            function, handle = c.lib.voxc_tracer_trace_bounded, self._bounded()
        c.check(function(handle, rays.ctypes.data, rays.size, hits.ctypes.data))
        return hits

    @in_turn
    def update(self, volume: Volume) -> int:
        """Takes another volume of the same format, such as an edited one, in place of its own. Only what differs is brought
        to the device, or all in place of an `Editable` that was followed; returns how many bytes that was. A volume of
        another format takes a tracer of its own: `volume.tracer()`."""
        self._check_idle()
        given = _handle_of(volume, "Volume")
        copied = ctypes.c_uint64()
        total = 0
        handles = [handle for handle in (self._handle, self._bounded_handle) if handle]
        for handle in {handle.value: handle for handle in handles}.values():
            c.check(c.lib.voxc_tracer_update(handle, given, ctypes.byref(copied)))
            total += copied.value
        self._volume = volume
        return total

    def follow(self, editable: Editable) -> int:
        """Goes on with an `Editable` as it is now, which was made of the volume of this tracer, or followed by it before. Only
        what changed since then is brought to the device; returns how many bytes that was. Later edits show when it follows
        again. No other tracer may follow the same one."""
        given, copied = _handle_of(editable, "Editable"), ctypes.c_uint64()
        with both_in_turn(self, editable):
            self._check_idle()
            editable._begin_edit()
            state = editable.view()
            if self.device == "cpu":  # It reads words where they lie, and those of a view stay as they are.
                c.check(c.lib.voxc_tracer_update(self._handle, state._handle, ctypes.byref(copied)))
            else:
                c.check(c.lib.voxc_tracer_follow(self._handle, given, ctypes.byref(copied)))
            self._volume = state
            if self._bounded_handle and self._bounded_handle.value != self._handle.value:
                c.lib.voxc_tracer_free(self._bounded_handle)
                self._bounded_handle = None
        return copied.value

    @in_turn
    def render(self, width: int = 1280, height: int = 720, *, style: Optional[str] = None, view: Optional[str] = None, eye: Any = None,
               look: Any = None, fov: Optional[float] = None, samples: Optional[int] = None, progress: Any = None, clip_box: Any = None,
               clip_planes: Any = None, orthographic: bool = False, view_height: Optional[float] = None) -> Picture:
        """A picture as an array (height, width, 4) of uint8, which a notebook shows. `style` and `view` are those of `voxc render`; `eye` and
        `look` are points in voxels, both or neither. `clip_box`, two corners in voxels, shows what lies between them,
        and each of `clip_planes`, (nx, ny, nz, d), cuts away where nx x + ny y + nz z is less than d; inner voxels show
        at a cut, and the kernel for rays with bounds is compiled when cuts are first asked for. `orthographic` pictures
        are made by parallel rays, and show `view_height` voxels from bottom to top."""
        self._check_idle()
        reporter = c.Reporter(progress)
        eye, look, box = _point(eye, "eye"), _point(look, "look"), _clip_box(clip_box)
        planes, plane_count = _clip_planes(clip_planes)
        pointer = lambda point: None if point is None else ctypes.cast(point, ctypes.POINTER(ctypes.c_double))
        options = c.options(c.PictureOptions, width=width, height=height, style=c.text(style), view=c.text(view),
                            eye=pointer(eye), look=pointer(look), vertical_fov=fov, samples=samples,
                            progress=reporter.pointer, orthographic=int(bool(orthographic)), view_height=view_height,
                            clip_box=pointer(box), clip_planes=pointer(planes), clip_plane_count=plane_count)
        if not (0 < width <= 32768 and 0 < height <= 32768):
            raise ValueError(f"a picture has 1 to 32768 pixels on each axis, not {width} x {height}")
        pixels = np.empty((height, width, 4), np.uint8)
        handle = self._handle if box is None and planes is None else self._bounded()
        self._is_rendering = True
        try:
            reporter.call(c.lib.voxc_render, handle, ctypes.byref(options), pixels.ctypes.data)
        finally:
            self._is_rendering = False
        return pixels.view(Picture)
