"""Writing files as a whole."""
import os
import stat
import sys

from .problems import EnvironmentProblem


def is_file(path):
    """Whether a page there is a file, beside which another may stand; and no device."""
    try:
        return stat.S_ISREG(os.stat(path).st_mode)
    except OSError:
        return True


def write(path, text):
    """Writes a file as a whole, or leaves what was there."""
    data = text.encode("utf-8", "replace")
    try:
        if path == "-":
            sys.stdout.buffer.write(data)
            sys.stdout.buffer.flush()
        elif not is_file(path):
            with open(path, "wb") as file:
                file.write(data)
        else:
            write_whole(path, data)
    except OSError as error:
        raise EnvironmentProblem(f"cannot write '{path}': {error.strerror}") from error


def write_whole(path, data):
    unfinished = f"{path}.unfinished-{os.getpid()}"
    try:
        with open(unfinished, "wb") as file:
            file.write(data)
        os.replace(unfinished, path)
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)
