# "rays": rays of all kinds through a volume of 32 voxels a side. "words FILE": the words of a volume that is not compressed.
import random
import struct
import sys

if sys.argv[1] == "rays":
    r = random.Random(7)
    for _ in range(20000):
        origin = [r.choice([r.uniform(-10, 42), float(r.randint(-1, 33)), r.gauss(0, 1) * 10 ** r.randint(-40, 30)]) for _ in range(3)]
        direction = [r.choice([0.0, 1.0, -1.0, r.gauss(0, 1), r.gauss(0, 1) * 10 ** r.randint(-40, 30)]) for _ in range(3)]
        sys.stdout.buffer.write(struct.pack("<6f", *origin, *direction))
else:
    with open(sys.argv[2], "rb") as file:
        volume = file.read()
    (count,) = struct.unpack_from("<Q", volume, 168 + 40)
    (offset,) = struct.unpack_from("<Q", volume, 168 + 48)
    sys.stdout.buffer.write(volume[offset : offset + 4 * count])
