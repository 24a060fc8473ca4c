#!/usr/bin/env python3
"""Holds what knows of a system to one folder: platform.py TREE LIST

LIST has a line "files: a/folder/ a/file.cpp" of the files below TREE/lib and TREE/include that may include headers of POSIX or of
Windows, or ask by the preprocessor which system this is. A folder ends in a slash. Everything else in LIST is prose.
"""
import re
import sys
from pathlib import Path

LINE = re.compile(r"^files:(.*)$", re.MULTILINE)
HEADERS = (
    r"sys/\S+|arpa/\S+|net\w*/\S+|unistd\.h|fcntl\.h|dlfcn\.h|sched\.h|pthread\.h|dirent\.h|poll\.h|spawn\.h|termios\.h|pwd\.h|malloc\.h"
    r"|io\.h|direct\.h|process\.h|windows\.h|\w*api\.h"
)
KNOWS = re.compile(
    rf"^ *# *include *<({HEADERS})>"
    r"|^ *# *(?:el)?if.*\b(_WIN32|_WIN64|WIN32|__MINGW\w+|__linux__|__linux|__APPLE__|__unix__|_POSIX_\w+)\b",
    re.MULTILINE,
)


def knowing(tree):
    """Every file that knows of a system, and by what."""
    for folder in ("include", "lib"):
        for path in sorted((tree / folder).rglob("*")):
            if path.suffix in (".h", ".cpp") and (found := KNOWS.search(path.read_text())):
                yield path.relative_to(tree).as_posix(), found[1] or found[2]


def main(tree, listing):
    allowed = [name for names in LINE.findall(Path(listing).read_text()) for name in names.split()]
    found = dict(knowing(Path(tree)))

    def covers(name, file):
        return file == name or (name.endswith("/") and file.startswith(name))

    wrong = [
        f"{file}: knows of a system by {by}; that is a matter of lib/Support/Platform"
        for file, by in found.items()
        if not any(covers(name, file) for name in allowed)
    ]
    wrong += [f"{name}: is listed, but knows of no system" for name in allowed if not any(covers(name, file) for file in found)]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main(*sys.argv[1:])
