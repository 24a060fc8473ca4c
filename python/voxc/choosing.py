"""Which format a scene asks for: predicted, or measured."""
from __future__ import annotations

import ctypes
import os
from typing import Any, Dict, Iterable, List, Optional, Union

from . import _library as c
from ._names import refuse_unknown
from .building import INPUT_OPTIONS, input_options_of
from .told import Told
from .tracer import rays_as_given

Row = Dict[str, Any]


def suggest(input: Union[str, os.PathLike], *, objective: Optional[str] = None, max_bytes: Optional[int] = None,
            device: Optional[str] = None, formats: Optional[Iterable[str]] = None, rays: Any = None, editable: bool = False,
            threads: Optional[int] = None, memory_bytes: Optional[int] = None, progress: Any = None, **input_options: Any) -> List[Row]:
    """What is predicted of formats for an input, without building any, as `voxc suggest`: a row for each, which pandas.DataFrame takes, with

    format, passes         as voxc.Format and voxc.build take them
    bytes, bits_per_voxel  of its words, and whether they are `exact`
    SET_rays_per_second    for each set of rays: camera_rays_per_second and bounced_rays_per_second, of one core where the device is a processor
    frontier               whether no other is as small and as fast, or better
    chosen                 whether it is what the `objective` asks for: "balanced" (default), "fastest" or "smallest"

    Formats of more than `max_bytes` are left out; with `formats` only these are rated. `rays` is an array of voxc.RAY, or a pair of origins and
    directions, in place of those of a camera and from surface to surface. `editable` keeps to formats whose volumes can be edited in place.
    Other options are those of an input, as of voxc.build, with a `resolution` of 512 by default. UsageError: no such objective; InputError: no such format,
    or none that holds the input."""
    return _rows(c.lib.voxc_suggest, "suggest", input, input_options, progress, _predicted,
                 dict(objective=objective, max_bytes=max_bytes, device=device, formats=formats, rays=rays, editable=int(editable),
                      threads=threads, memory_bytes=memory_bytes))


def search(input: Union[str, os.PathLike], budget: Optional[float] = None, *, objective: Optional[str] = None,
           max_bytes: Optional[int] = None, device: Optional[str] = None, precision: Optional[str] = None,
           formats: Optional[Iterable[str]] = None, rays: Any = None, threads: Optional[int] = None,
           memory_bytes: Optional[int] = None, progress: Any = None, **input_options: Any) -> List[Row]:
    """Builds and measures formats for an input, as `voxc search`, for `budget` seconds (180 by default): a row for each that was measured, as of
    `suggest`, where SET_rays_per_second is the median of several rounds, and with

    SET_slowest_rays_per_second, SET_fastest_rays_per_second  of the rounds
    SET_predicted_rays_per_second                             before it was measured
    checked_rays, wrong_rays, max_ulp                         of all sets: rays whose hits were compared with exact ones, those that differ, and how
                                                              far t is off at most, in units of its last place
    failure                                                   why there are no speeds; None: there are

    `device` is the best one by default, and `precision` "exact". The records and the page of `voxc search -o FOLDER` are the program's."""
    if budget == 0:
        raise ValueError("a budget is seconds, more than 0")
    return _rows(c.lib.voxc_search, "search", input, input_options, progress, _measured,
                 dict(objective=objective, max_bytes=max_bytes, device=device, precision=precision, formats=formats, rays=rays,
                      seconds=budget, threads=threads, memory_bytes=memory_bytes))


def _rows(function, name, input, input_options, progress, speeds, asked):
    refuse_unknown(name, input_options, INPUT_OPTIONS)
    told, reporter = Told(), c.Reporter(progress)
    listed = [asked["formats"]] if isinstance(asked["formats"], str) else asked["formats"]
    formats = None if listed is None else [c.needed(text, "a format") for text in listed]
    if formats == []:
        raise ValueError(f"{name} has no formats to choose among; None are those that it knows")
    if asked["max_bytes"] is not None and asked["max_bytes"] == 0:
        raise ValueError("max_bytes is 1 or more; None is no bound")
    rays = None if asked["rays"] is None else rays_as_given(asked["rays"])
    if rays is not None and rays.size == 0:
        raise ValueError(f"{name} has no rays; None are those that it makes")
    texts = {key: c.text(asked.pop(key, None)) for key in ("objective", "device", "precision")}
    del asked["formats"], asked["rays"]
    options = c.options(c.ChoiceOptions, progress=reporter.pointer, **texts, **asked)
    if formats is not None:
        options.formats, options.format_count = (ctypes.c_char_p * len(formats))(*formats), len(formats)
    if rays is not None:
        options.rays, options.ray_count = rays.ctypes.data, rays.size
    table = ctypes.c_void_p()
    try:
        try:
            reporter.call(function, c.needed(input, "an input"), ctypes.byref(input_options_of(told, **input_options)), ctypes.byref(options),
                          ctypes.byref(table))
        finally:
            told.warn(3)
        return [_row(table, number, speeds) for number in range(c.lib.voxc_format_table_rows(table))]
    finally:
        c.lib.voxc_format_table_free(table)


def _row(table, number, speeds):
    row, voxels = c.FormatRow(), c.lib.voxc_format_table_voxels(table)
    c.lib.voxc_format_table_row(table, number, ctypes.byref(row))
    sets = {}
    for number_of_set in range(c.lib.voxc_format_table_sets(table)):
        speed = sets[c.lib.voxc_format_table_set(table, number_of_set).decode()] = c.FormatSpeed()
        c.lib.voxc_format_table_speed(table, number, number_of_set, ctypes.byref(speed))
    return {"format": row.format.decode(), "passes": row.passes.decode(), "bytes": row.bytes,
            "bits_per_voxel": 8 * row.bytes / voxels if voxels else float("nan"), "exact": bool(row.exact),
            **speeds(sets, row), "frontier": bool(row.frontier), "chosen": bool(row.chosen)}


def _predicted(sets, row):
    return {f"{name}_rays_per_second": speed.predicted for name, speed in sets.items()}


def _measured(sets, row):
    made = {}
    for name, speed in sets.items():
        made.update({f"{name}_rays_per_second": speed.measured, f"{name}_slowest_rays_per_second": speed.slowest,
                     f"{name}_fastest_rays_per_second": speed.fastest, f"{name}_predicted_rays_per_second": speed.predicted})
    return dict(made, checked_rays=sum(speed.checked_rays for speed in sets.values()),
                wrong_rays=sum(speed.wrong_rays for speed in sets.values()), max_ulp=max((speed.max_ulp for speed in sets.values()), default=0.0),
                failure=row.failure.decode(errors="replace") if row.failure else None)
