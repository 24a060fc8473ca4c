"""The format "auto": that which `voxc suggest` names, built by the program."""
import os
import pathlib
import tempfile

import numpy as np

from ._program import run
from .told import Told
from .volume import Volume


def build_automatic(build, input, words, threshold, path, compress, options):
    """Builds a file, or what `build` makes of arrays, in the format that suits it; `options` are the program's."""
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        if input is None:
            input, threshold = _plain(build, words, threshold, scratch / "plain.hvx"), None
        output = pathlib.Path(path) if path is not None else scratch / "volume.hvx"
        command = ["build", "auto", os.fspath(input), "-o", os.fspath(output)]
        given = dict(options, threshold=threshold)
        z_up = given.pop("z_up", None)
        if z_up is not None:
            command.append("--up=" + ("z" if z_up else "y"))
        flags = {"--crop": given.pop("crop", None), "--compress": compress}
        command += [f"--{name.replace('_', '-')}={_word(value)}" for name, value in given.items() if value is not None]
        told = Told()
        try:
            run(command + [name for name, is_set in flags.items() if is_set], said=told.read)
        finally:
            told.warn(3)
        volume = Volume.load(output, trusted=True)  # A mapped file stays when its name is gone.
        volume._told = told
        return volume


def _word(value):
    """A value as the program takes it: several numbers with commas between."""
    return ",".join(map(str, value)) if isinstance(value, (tuple, list, np.ndarray)) else str(value)


def _plain(build, words, threshold, path):
    """A volume of the arrays, in a format that takes all of them."""
    build("G(21)", path=path, threshold=threshold, **words)
    return path
