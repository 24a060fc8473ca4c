"""The program voxc, where the library has no function for what it does."""
from __future__ import annotations

import os
import subprocess
from typing import Any, Callable, List, Optional

from ._errors import error_of
from ._library import installed


def run(arguments: List[str], program: Optional[str] = None, said: Callable[[str], Any] = lambda text: None) -> None:
    """Runs voxc with these arguments; what it says when it fails is raised, and what it said before goes to `said`. MachineError: the
    program is not found."""
    name = program or os.environ.get("VOXC") or installed("bin/voxc") or "voxc"
    try:
        done = subprocess.run([name, *arguments], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    except OSError as reason:
        raise error_of(f"this runs the program voxc, and '{name}' cannot be run: {reason.strerror}; VOXC names another", 3) from None
    before, _, failure = done.stderr.rpartition("voxc: error: ")
    said(before if done.returncode else done.stderr)
    if done.returncode == 130:
        raise KeyboardInterrupt
    if done.returncode:
        raise error_of(failure.strip(), done.returncode)
