#!/usr/bin/env python3
"""Holds the includes between rooms of the tools to a list: rooms.py TREE FOLDER LIST [MOST]

A room is a folder of TREE/FOLDER, with all that is below it. LIST has a line "room -> room room" for each, as arrows.py reads it: the
rooms whose headers it includes. They stand above it, so that rooms go in no circle; MOST bounds how many arrows there are between rooms
of FOLDER. A line may name a room of another house, such as testing, tools/common or tools/voxc/building. What a room includes that stands
beside FOLDER is held by another list, as are the rooms within it. Public headers of the library, voxc/Part/Header.h, are everyone's;
private ones are not, but for lines "room/File.cpp => Part/Header.h".
"""
import sys
from pathlib import Path

import arrows

HOUSES = (".", "tools", "tools/voxc")


class House:
    def __init__(self, tree, folder):
        self.tree, self.root = tree, tree / folder
        self.rooms = {path.name for path in self.root.iterdir() if path.is_dir()}

    def room_of(self, room, header):
        """The room that a header in quotes belongs to, be it allowed or not; None if that is not this house's matter."""
        rest = header.removeprefix(self.root.name + "/")  # As a part names its own rooms.
        header = rest if rest.split("/")[0] in self.rooms else header
        folder = header.split("/")[0] if "/" in header else None
        is_own = folder is None or folder == "voxc" or (self.root / room / folder).is_dir()
        is_beside = self.root.parent != self.tree and (self.root.parent / str(folder)).is_dir()
        return None if is_own or (is_beside and folder not in self.rooms) else folder

    def arrows(self):
        """Every include of another room: room, file, header, the other's room."""
        for room, path, mark, header in arrows.includes(self.root):
            other = self.room_of(room, header) if mark == '"' else None
            if other not in (None, room):
                yield room, path, header, other


def strays(found, allowed, exceptions):
    for room, path, header, other in found:
        is_exception = ("/".join(path.parts[-2:]), header) in exceptions
        if other not in allowed.get(room, []) and not is_exception:
            yield f"{path}: {room} must not include {header}; the list has no {room} -> {other}"


def leftovers(found, allowed):
    used = {(room, other) for room, _, _, other in found}
    for room, others in allowed.items():
        for other in others:
            if (room, other) not in used:
                yield f"{room} -> {other}: nothing in {room} includes {other}; strike it from the list"


def strangers(house, allowed):
    for room in sorted(house.rooms - allowed.keys()):
        yield f"{room}: the list has no line for this room"
    for room in sorted(allowed.keys() - house.rooms):
        if not any((house.tree / other / room).is_dir() for other in HOUSES):
            yield f"{room}: the list has a line for it, but there is no such room"


def crowds(house, allowed, most):
    number = sum(len(house.rooms.intersection(others)) for others in allowed.values())
    if number > most:
        yield f"there are {number} arrows between rooms; more than {most} nobody keeps in mind"


def main():
    tree, list_path = Path(sys.argv[1]), Path(sys.argv[3])
    house, allowed, exceptions = House(tree, sys.argv[2]), arrows.read_list(list_path), arrows.read_exceptions(list_path)
    most = int(sys.argv[4]) if len(sys.argv) > 4 else sys.maxsize
    found = list(house.arrows())
    wrong = [*strangers(house, allowed), *arrows.circles(allowed), *strays(found, allowed, exceptions), *leftovers(found, allowed),
             *crowds(house, allowed, most)]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main()
