"""needs.py FILE...: tells what libraries and programs ask of a system, and ends with 1 if it is more than every system with
glibc 2.28 has: another library than those of glibc, a newer version of a name, or a path of this machine to look for libraries in."""
import os
import re
import subprocess
import sys

NEWEST = (2, 28)
# The loader's own name, and what glibc 2.28 consists of; libraries of voxc lie beside.
LIBRARIES = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1", "libvoxc.so.0"}
# Loaded when a window is opened, and only then.
OF_WINDOWS = {"libglfw.so.3": {"libX11.so.6"}}
# Names that were not in libc.so.6 then: glibc before 2.30 looks for a name no further than in the library that it is asked of.
ELSEWHERE = re.compile(r"dl(open|sym|close|error|addr)|(__)?pthread_(create|join|once|key_\w+|[gs]etspecific|rwlock_\w+|mutexattr_\w+)|sem_\w+")


def read(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True, check=True, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C"}).stdout


def of_libc(path):
    """The names that a file asks of libc.so.6."""
    numbers, asked = {}, None
    for line in read("readelf", "--version-info", "--wide", path).splitlines():
        asked = (re.search(r"File: (\S+)", line) or [None, asked])[1]
        for number in re.findall(r"Name: GLIBC_\S+.*Version: (\d+)", line):
            numbers[number] = asked
    symbols = re.findall(r" UND (\w+)@GLIBC_\S+ \((\d+)\)", read("readelf", "--dyn-syms", "--wide", path))
    return [name for name, number in symbols if numbers.get(number) == "libc.so.6"]


def needs(path):
    """What one file asks for, in words, and what of that is too much."""
    dynamic, symbols = read("readelf", "--dynamic", "--wide", path), read("readelf", "--dyn-syms", "--wide", path)
    libraries = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic)
    folders = re.findall(r"\(R(?:UN)?PATH\).*\[(.*)\]", dynamic)
    versions = set(re.findall(r" UND \S*@((?:GLIBC|GLIBCXX|CXXABI|GCC)_[A-Z0-9_.]+)", symbols))
    numbers = {version: tuple(map(int, version[6:].split("."))) for version in versions if re.fullmatch(r"GLIBC_[0-9.]+", version)}
    # Relocations that are packed are no name, but an old loader would pass them over.
    packed = ["packed relocations, which glibc knows from 2.36 on"] if "(RELR)" in dynamic else []
    allowed = LIBRARIES | OF_WINDOWS.get(os.path.basename(path), set())
    wrong = ([f"the library {name}" for name in libraries if name not in allowed] +
             [f"libraries in {folder}" for folder in folders if not folder.startswith("$ORIGIN")] +
             sorted(versions - numbers.keys()) + [version for version in sorted(numbers, key=numbers.get) if numbers[version] > NEWEST] +
             [f"{name} of libc.so.6" for name in of_libc(path) if ELSEWHERE.fullmatch(name)] + packed)
    newest = max(numbers, key=numbers.get, default="nothing of glibc")
    return f"{path} needs {', '.join(libraries) or 'no library'} and {newest}", wrong


def main():
    failed = False
    for path in sys.argv[1:]:
        told, wrong = needs(path)
        print(told)
        for what in wrong:
            failed = True
            print(f"{path} asks for {what}, which not every system with glibc {'.'.join(map(str, NEWEST))} has", file=sys.stderr)
    sys.exit(failed)


main()
