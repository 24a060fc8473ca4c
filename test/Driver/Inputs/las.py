#!/usr/bin/env python3
"""Writes a LAS 1.2 file of three points with colours, in coordinates of a map: las.py FILE"""
import struct, sys
points = [((0, 0, 0), (65535, 0, 0)), ((2500, 0, 1000), (0, 65535, 0)), ((0, 3500, 4000), (0, 0, 65535))]
head = bytearray(227)
struct.pack_into('<4s', head, 0, b'LASF')
struct.pack_into('<BB', head, 24, 1, 2)
struct.pack_into('<HII', head, 94, 227, 227, 0)
struct.pack_into('<BHI', head, 104, 2, 26, len(points))
struct.pack_into('<6d', head, 131, 0.001, 0.001, 0.001, 33500000.25, 5800000.5, 100)
with open(sys.argv[1], 'wb') as file:
    file.write(head + b''.join(struct.pack('<3iH6x3H', *place, 0, *colour) for place, colour in points))
