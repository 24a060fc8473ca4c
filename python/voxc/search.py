"""Searching formats for a scene, by the tool."""
import csv
import os
import pathlib
import tempfile

from ._program import run


def search(input, folder=None, budget=None, program=None, **options):
    """Runs `voxc search INPUT` and returns its rows, a dictionary for each format that was measured: those of its CSV file,
    with numbers where they are such. Without a `folder` the records are not kept. `budget` is in seconds; other options
    are those of the tool: max_bytes="64MiB", device="cpu"."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(folder or scratch)
        command = ["search", os.fspath(input), "-o", os.fspath(folder), "--quiet"]
        if budget is not None:
            command += ["--budget", f"{budget}s"]
        for name, value in options.items():
            command.append("--" + name.replace("_", "-") + ("" if value is True else f"={value}"))
        run(command, program)
        [table] = folder.glob("*.csv")
        with open(table, newline="") as file:
            return [{name: _number(value) for name, value in row.items()} for row in csv.DictReader(file)]


def _number(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
