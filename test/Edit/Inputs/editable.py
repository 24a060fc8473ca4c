"""Edits through Python, held against the same edits of an array."""
import numpy as np
import voxc

SIDE = 32
grid = np.zeros((SIDE, SIDE, SIDE), np.uint32)
grid[:4] = 0xFF808080
z, y, x = np.mgrid[:SIDE, :SIDE, :SIDE]
world = voxc.Editable(voxc.build("D(2, 2, 2, 4) G(3)", voxels=grid))
tracer = world.view().tracer("cpu")
states = []


def expect(what):
    assert np.array_equal(world.view().read(), grid), what
    assert world.voxels == np.count_nonzero(grid), what
    states.append((world.snapshot(), grid.copy()))


expect("first")
world.set_box((3, 4, 2), (5, 6, 7), 0xFF0000FF)
grid[2:9, 4:10, 3:8] = 0xFF0000FF
expect("box")
world.set_sphere((20, 20, 5), 6, 0xFF00FF00)
grid[(x - 20) ** 2 + (y - 20) ** 2 + (z - 5) ** 2 <= 36] = 0xFF00FF00
expect("sphere")
world.clear((0, 0, 0), (16, 16, 3))
grid[:3, :16, :16] = 0
expect("clear")
places = np.random.default_rng(1).integers(0, SIDE, (100, 3))
world.set_voxels(places, 0xFF123456)
grid[places[:, 2], places[:, 1], places[:, 0]] = 0xFF123456
expect("list")
world.paste(voxc.build("G(3)", voxels=np.full((5, 5, 5), 0xFFFFFF00, np.uint32)), (25, 1, 9))
grid[9:14, 1:6, 25:30] = 0xFFFFFF00
expect("paste")
world.apply((8, 8, 8), (9, 9, 9), lambda x, y, z, word: 0 if (x + y + z) % 2 else word)
where = (x >= 8) & (x < 17) & (y >= 8) & (y < 17) & (z >= 8) & (z < 17) & ((x + y + z) % 2 == 1)
grid[where] = 0
expect("function")

for snapshot, words in states:
    world.restore(snapshot)
    assert np.array_equal(world.view(snapshot).read(), words)
    tracer.follow(world)
    hits = tracer.trace(np.array([[4.5, 5.5, -9.0]]), np.array([[0.0, 0.0, 1.0]]))
    column = np.flatnonzero(words[:, 5, 4])
    assert hits["voxel"][0, 2] == column[0], (hits, column)
assert np.array_equal(world.compact().words, voxc.build("D(2, 2, 2, 4) G(3)", voxels=grid).words)
animation = world.framed([snapshot for snapshot, _ in states])
assert animation.frames == len(states) and np.array_equal(animation.read(), states[0][1])
animation.save("animation.hvx")
for number, (_, words) in enumerate(states):
    frame = voxc.Volume.load("animation.hvx", frame=number + 1)
    assert np.array_equal(frame.read(), words) and frame.frames == 1
again = voxc.Editable(voxc.Volume.load("animation.hvx"))
assert [frame.voxels for frame in again.frames] == [snapshot.voxels for snapshot, _ in states]
again.restore(again.frames[3])
assert np.array_equal(again.view().read(), states[3][1])
print("all is as NumPy has it")

try:
    voxc.Editable(voxc.build("M(2, 2, 2) M(2, 2, 2)", voxels=grid[:16, :16, :16], passes="values-apart"))
except voxc.Error as error:
    print(f"{error.kind}: {error}")


def refuse(*_):
    raise ValueError("no")


try:
    world.set_voxels([[0.5, 0, 0]], 0xFF123456)
except ValueError as error:
    print("ValueError", error)
before = world.voxels
try:
    world.apply((0, 0, 0), (2, 2, 2), refuse)
except ValueError as error:
    print("ValueError", error)
assert world.voxels == before
