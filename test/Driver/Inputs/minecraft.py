#!/usr/bin/env python3
"""Writes a Sponge schematic of version 2 and a Litematica file of two regions, as their formats say: minecraft.py FOLDER"""
import gzip, struct, sys

def tag(kind, name, payload):
    return struct.pack('>bH', kind, len(name)) + name.encode() + payload

def number(name, value): return tag(3, name, struct.pack('>i', value))
def short(name, value): return tag(2, name, struct.pack('>H', value))
def array(name, data): return tag(7, name, struct.pack('>i', len(data)) + bytes(data))
def compound(name, *tags): return tag(10, name, b''.join(tags) + b'\0')
def text(name, value): return tag(8, name, struct.pack('>H', len(value)) + value.encode())
def compounds(name, items): return tag(9, name, struct.pack('>bi', 10, len(items)) + b''.join(items))
def place(name, v): return compound(name, *(number(axis, n) for axis, n in zip('xyz', v)))

def region(name, position, size, names, numbers):
    bits = max(2, (len(names) - 1).bit_length())
    whole = sum(n << bits * i for i, n in enumerate(numbers))
    count = (len(numbers) * bits + 63) // 64
    longs = b''.join(struct.pack('>Q', whole >> 64 * i & (1 << 64) - 1) for i in range(count))
    return compound(name, place('Position', position), place('Size', size),
                    compounds('BlockStatePalette', [text('Name', n) + b'\0' for n in names]),
                    tag(12, 'BlockStates', struct.pack('>i', count) + longs), compounds('Entities', [b'\0']))

# A floor of grass with a wall of oak on it, and a lamp: 4 x 3 x 4.
names = ['minecraft:air', 'minecraft:grass_block[snowy=false]', 'minecraft:oak_planks', 'minecraft:torch', 'mod:lamp']
cells = [1 if y == 0 else 2 if z == 0 and y == 1 else 3 if (x, y, z) == (0, 2, 0) else 4 if (x, y, z) == (3, 1, 3) else 0
         for y in range(3) for z in range(4) for x in range(4)]
folder = sys.argv[1] + '/'
with open(folder + 'wall.schem', 'wb') as file:
    file.write(gzip.compress(compound('Schematic', number('Version', 2), short('Width', 4), short('Height', 3), short('Length', 4),
        compound('Palette', *(number(n, i) for i, n in enumerate(names))), array('BlockData', cells)), mtime=0))
# The same, as one region of a negative size.
with open(folder + 'wall.litematic', 'wb') as file:
    file.write(gzip.compress(compound('', number('Version', 6), compound('Regions', region('r', (3, 0, 3), (-4, 3, -4), names, cells))), mtime=0))
