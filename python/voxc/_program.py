"""The program voxc, where the library has no function for what it does."""
import os
import subprocess

from ._library import Error, installed


def run(arguments, program=None, said=lambda text: None):
    """Runs voxc with these arguments; what it says when it fails is raised, and what it said before goes to `said`. Error: the
    program is not found."""
    name = program or os.environ.get("VOXC") or installed("bin/voxc") or "voxc"
    try:
        done = subprocess.run([name, *arguments], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    except OSError as failure:
        raise Error(f"this runs the program voxc, and '{name}' cannot be run: {failure.strerror}; VOXC names another", 3) from None
    before, _, failure = done.stderr.rpartition("voxc: error: ")
    said(before if done.returncode else done.stderr)
    if done.returncode == 130:
        raise KeyboardInterrupt
    if done.returncode:
        raise Error(failure.strip(), done.returncode)
