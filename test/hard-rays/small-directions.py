"""Writes rays in a plane, through edges and next to them, whose directions are so small that any t is above 2^100."""
import random
import struct
import sys

random.seed(4)
with open(sys.argv[1], "wb") as file:
    for _ in range(5000):
        origin = (float(random.randrange(64)), float(random.randrange(64)), random.uniform(0, 64))
        slope = random.choice([1.0, -1.0, 0.5, 1.0 + 2.0 ** -23, random.uniform(0, 1)])
        still = [random.choice([1.0, -1.0]), slope, 0.0]
        size = 2.0 ** -random.uniform(100, 118)
        file.write(struct.pack("6f", *origin, *(size * c for c in still)))
