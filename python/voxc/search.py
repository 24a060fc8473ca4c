"""Searching formats for a scene, by the tool."""
from __future__ import annotations

import csv
import os
import pathlib
import tempfile
from typing import Any, Dict, List, Optional, Union

from ._program import run, words_of


def search(input: Any, folder: Union[str, os.PathLike, None] = None, budget: Optional[float] = None, program: Optional[str] = None,
           **options: Any) -> List[Dict[str, Any]]:
    """Runs `voxc search INPUT` and returns its rows, a dictionary for each format that was measured: those of its CSV file,
    with numbers where they are such. pandas.DataFrame takes them. Without a `folder` the records are not kept. `budget` is in seconds;
    other options are those of the tool: max_bytes="64MiB", device="cpu"."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(folder or scratch)
        command = ["search", os.fspath(input), "-o", os.fspath(folder), "--quiet"]
        if budget is not None:
            command += ["--budget", f"{budget}s"]
        run(command + words_of(options), program)
        [table] = folder.glob("*.csv")
        with open(table, newline="") as file:
            return [{name: _number(value) for name, value in row.items()} for row in csv.DictReader(file)]


def _number(text: str) -> Union[int, float, str]:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
