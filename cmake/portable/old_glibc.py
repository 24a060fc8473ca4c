"""old_glibc.py FOLDER NEWEST COMPILER...: libraries to link against in place of this machine's C library, which have no name and no version of
a name that came after GLIBC_NEWEST (such as 2.28). What is linked so runs wherever the C library is that old or newer.

A library of glibc keeps every version that a name ever had. Here each name is left with the newest that is old enough, as a
linker of that time would have seen it; what is newer as a whole is missing, and NewerNames.c has it. These libraries are
only linked against: what they hold is never called. Names that newer systems have in libc.so.6, and older ones in libpthread.so.0,
libdl.so.2 or librt.so.1, are in these here: glibc before 2.30 finds a name only if it is in the library that it was linked with."""
import pathlib
import re
import subprocess
import sys

# What is linked by -lNAME, and the library that is loaded for it.
LIBRARIES = {"c": "libc.so.6", "m": "libm.so.6", "pthread": "libpthread.so.0", "dl": "libdl.so.2", "rt": "librt.so.1"}
# Where names were that moved to libc.so.6 after NEWEST, which gave each a version more.
MOVED = {"dl": r"dl[a-z]", "rt": r"(timer|mq|aio|lio|shm)_", "pthread": r"(__)?(pthread|sem|thrd|mtx|cnd|tss)_|call_once$"}
# Names that nothing is linked to today, but was then: NewerNames.c calls them.
LINKED_THEN = {"__xstat", "__fxstat", "__lxstat", "__fxstatat", "__xmknod"}
LOADER = {"x86_64": "ld-linux-x86-64.so.2", "aarch64": "ld-linux-aarch64.so.1"}


def place(compiler, file):
    return pathlib.Path(subprocess.run([*compiler, f"-print-file-name={file}"], capture_output=True, text=True, check=True).stdout.strip())


def number(version):
    """GLIBC_2.2.5 as (2, 2, 5); None for what is no version of an interface, such as GLIBC_PRIVATE."""
    match = re.fullmatch(r"GLIBC_(\d+(?:\.\d+)+)", version)
    return tuple(map(int, match[1].split("."))) if match else None


def names_of(library, newest):
    """Name: (version, whether it is data, bytes), of those that are old enough; and the names of which there are newer versions too."""
    found, newer, kept = {}, set(), set()
    table = subprocess.run(["readelf", "--dyn-syms", "--wide", library], capture_output=True, text=True, check=True).stdout
    for line in table.splitlines():
        row = line.split()
        if len(row) < 8 or row[6] == "UND" or "@" not in row[7]:
            continue
        name, _, version = row[7].partition("@")
        is_linked, version = version.startswith("@"), version.lstrip("@")
        if number(version) is None or number(version) > newest:
            newer.add(name)
            continue
        if is_linked:
            kept.add(name)
        if name not in found or number(found[name][0]) < number(version):
            found[name] = (version, row[3] == "OBJECT", int(row[2], 0))
    # A name that has old versions alone, none of which is for linking, is there for programs that are older still.
    return {name: row for name, row in found.items() if name in newer | kept | LINKED_THEN}, newer


def write(folder, file, names):
    versions = sorted({version for version, _, _ in names.values()}, key=number)
    text = [".text", *(f".symver here_{name},{name}@@{version}" for name, (version, _, _) in names.items())]
    for name, (_, is_data, size) in names.items():
        text += [f".type here_{name},@{'object' if is_data else 'function'}", f".size here_{name},{size}", f".globl here_{name}",
                 f"here_{name}: .skip {max(size, 1) if is_data else 1}"]
    text.append('.section .note.GNU-stack,"",@progbits')
    (folder / f"{file}.s").write_text("\n".join(text) + "\n")
    (folder / f"{file}.map").write_text("".join(f"{version} {{ }};\n" for version in versions) or "{ local: *; };\n")
    subprocess.run([*sys.argv[3:], "-shared", "-nostdlib", "-fuse-ld=bfd", f"-Wl,-soname,{file}", f"-Wl,--version-script={folder / file}.map",
                    "-o", folder / file, folder / f"{file}.s"], check=True)


def main():
    folder, newest, compiler = pathlib.Path(sys.argv[1]), number("GLIBC_" + sys.argv[2]), sys.argv[3:]
    folder.mkdir(parents=True, exist_ok=True)
    machine = subprocess.run([*compiler, "-dumpmachine"], capture_output=True, text=True, check=True).stdout.partition("-")[0]
    names, newer = names_of(place(compiler, LIBRARIES["c"]), newest)
    held = {library: {name: names[name] for name in newer & names.keys() if re.match(moved, name)} for library, moved in MOVED.items()}
    held["c"] = {name: row for name, row in names.items() if not any(name in moved for moved in held.values())}
    held["m"], _ = names_of(place(compiler, LIBRARIES["m"]), newest)
    held["loader"], _ = names_of(place(compiler, LOADER[machine]), newest)
    for name, file in [*LIBRARIES.items(), ("loader", LOADER[machine])]:
        write(folder, file, held[name])
        # What the compiler adds for each program of its own, such as atexit, goes on to come from its archive.
        beside = f" {place(compiler, 'libc_nonshared.a')} {folder / LOADER[machine]}" if name == "c" else ""
        (folder / f"lib{name}.so").write_text(f"INPUT({folder / file}{beside})\n")


main()
