"""Which format a scene asks for, predicted by the tool."""
from __future__ import annotations

import json
import os
import pathlib
import tempfile
from typing import Any, Dict, List, Optional

from ._program import run, words_of


def suggest(input: Any, program: Optional[str] = None, **options: Any) -> List[Dict[str, Any]]:
    """What `voxc suggest INPUT` predicts of each format that it knows: rows, of which the one with `chosen` is what it names. Each has the
    `format`, its `passes` with blanks between, its `bytes` and `bits_per_voxel`, whether these are `exact`, the rays a second of one core
    by their kind, such as `camera_rays_per_second`, and whether no other beats it in both (`frontier`). pandas.DataFrame takes them.
    Options are those of the tool: resolution=512, objective="smallest", max_bytes="64MiB"."""
    with tempfile.TemporaryDirectory() as scratch:
        file = pathlib.Path(scratch) / "figures.json"
        run(["suggest", os.fspath(input), "--quiet", "--stats", str(file), *words_of(options)], program)
        figures = json.loads(file.read_text())
    return [_row(row, figures["voxels"]) for row in figures["formats"]]


def _row(row: Dict[str, Any], voxels: int) -> Dict[str, Any]:
    made = {"format": row["format"], "passes": " ".join(row["passes"]), "bytes": 4 * row["words"],
            "bits_per_voxel": 32 * row["words"] / voxels if voxels else float("nan"), "exact": row["exact"]}
    made.update({f"{kind}_rays_per_second": 1e9 / rays["nanoseconds"] for kind, rays in row["rays"].items() if rays["nanoseconds"] > 0})
    return dict(made, frontier=row["frontier"], chosen=row["chosen"])
