"""aarch64-rays.py FILE EDGE COUNT: rays through a cube of voxels on which processors may differ: from within and from far away, along the planes
between voxels, to where several voxels meet, and with a coordinate that is all but still."""
import random
import struct
import sys

chance = random.Random(5)


def point(edge):
    return [chance.uniform(0, edge) for _ in range(3)]


def corner(edge):
    return [float(chance.randint(0, edge)) for _ in range(3)]


def from_within(edge):
    return point(edge), [chance.gauss(0, 1) for _ in range(3)]


def from_afar(edge):
    to, towards = point(edge), [chance.gauss(0, 1) for _ in range(3)]
    distance = edge * 2 ** chance.uniform(0, 10)
    return [at - distance * step for at, step in zip(to, towards)], towards


def along_planes(edge):
    while not any(towards := [chance.choice((-1.0, 0.0, 1.0)) for _ in range(3)]):
        pass
    return [at - edge * step for at, step in zip(corner(edge), towards)], towards


def to_corners(edge):
    origin = [chance.choice((-1, 1)) * at for at in corner(4 * edge)]
    return origin, [to - at for to, at in zip(corner(edge), origin)]


def all_but_still(edge):
    origin, towards = from_afar(edge)
    towards[chance.randrange(3)] *= 2.0 ** -chance.randint(20, 140)
    return origin, towards


def main():
    path, edge, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    kinds = (from_within, from_afar, along_planes, to_corners, all_but_still)
    with open(path, "wb") as file:
        for number in range(count):
            origin, direction = kinds[number % len(kinds)](edge)
            file.write(struct.pack("<6f", *origin, *direction))


main()
