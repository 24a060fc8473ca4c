"""training_set.py FOLDER [MESH...]: voxels of many meshes as arrays to learn from, and the depths that cameras around see of them.

Without meshes there are 100 made up: boxes, balls and rings of chance sizes and turns. Each becomes FOLDER/NAME.npz with

    places   int32 (n, 3)     x, y and z of its voxels, from 0 to 63, in Morton order
    normals  float32 (n, 3)   the way out of the surface at each, from its 6 neighbours
    depths   float32 (v, 64, 64)  the t of the first voxel along parallel rays, for v views; 0 where there is none
    label    the number of its kind

and FOLDER/picture.png shows the first 25 of them."""
import pathlib
import sys
import tempfile

import numpy as np
import voxc

SIDE, VIEWS = 64, 6
KINDS = ("box", "ball", "ring")


def surface(kind, chance):
    """Points (h, w, 3) of a closed surface over two angles."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 49), np.linspace(0, 2 * np.pi if kind == "ring" else np.pi, 25))
    if kind == "ring":
        thick = chance.uniform(0.15, 0.45)
        points = np.stack([(1 + thick * np.cos(v)) * np.cos(u), (1 + thick * np.cos(v)) * np.sin(u), thick * np.sin(v)], -1)
    else:
        points = np.stack([np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), np.cos(v)], -1)
    if kind == "box":
        points /= np.abs(points).max(axis=-1, keepdims=True)
    turn, _ = np.linalg.qr(chance.normal(size=(3, 3)))
    return points * chance.uniform(0.4, 1, 3) @ turn


def write_mesh(path, points):
    """A surface as an .obj file of quads."""
    height, width = points.shape[:2]
    corner = np.arange(height * width).reshape(height, width) + 1
    quads = np.stack([corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]], -1).reshape(-1, 4)
    with open(path, "w") as file:
        file.writelines("v %g %g %g\n" % tuple(point) for point in points.reshape(-1, 3))
        file.writelines("f %d %d %d %d\n" % tuple(quad) for quad in quads)


def make_meshes(folder, count=100):
    chance = np.random.default_rng(1)
    for i in range(count):
        kind = i % len(KINDS)
        path = folder / f"{KINDS[kind]}-{i:03}.obj"
        write_mesh(path, surface(KINDS[kind], chance))
        yield path, kind


def normals_of(volume, places):
    """The way out at each voxel: away from those of its neighbours that are there."""
    solid = np.pad(volume.read() != 0, 1)
    x, y, z = (places + 1).T
    steps = np.stack([1.0 * solid[z, y, x - 1] - solid[z, y, x + 1], 1.0 * solid[z, y - 1, x] - solid[z, y + 1, x],
                      1.0 * solid[z - 1, y, x] - solid[z + 1, y, x]], -1)
    length = np.linalg.norm(steps, axis=-1, keepdims=True)
    return np.divide(steps, length, out=np.zeros_like(steps), where=length > 0).astype(np.float32)


def views():
    """Origins and directions (v, 64, 64, 3) of parallel rays along both ways of each axis."""
    grid = np.stack(np.meshgrid(*[np.arange(SIDE) + 0.5] * 2, indexing="ij"), -1)
    for axis in range(3):
        for begin, step in ((-1.0, 1), (SIDE + 1.0, -1)):
            yield np.insert(grid, axis, begin, axis=-1), np.eye(3)[axis] * step


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    rays = [np.stack([np.broadcast_to(part, (SIDE, SIDE, 3)) for part in view]) for view in views()]
    origins, directions = np.moveaxis(np.stack(rays), 1, 0)
    tracer, pictures = None, []
    with tempfile.TemporaryDirectory() as scratch:
        meshes = [(pathlib.Path(path), -1) for path in sys.argv[2:]] or make_meshes(pathlib.Path(scratch))
        for path, kind in meshes:
            volume = voxc.build("R(2^3) G(4)", path, resolution=SIDE, z_up=True, interior="fill")
            if tracer is None:
                tracer = volume.tracer("cpu")
            else:
                tracer.update(volume)  # The kernel is compiled once, and only words that differ are brought to it.
            places = volume.points().places
            np.savez_compressed(folder / f"{path.stem}.npz", places=places, normals=normals_of(volume, places),
                                depths=tracer.trace(origins, directions)["t"], label=kind)
            if len(pictures) < 25:
                pictures.append(tracer.render(160, 120, style="normals", view="iso"))
    blank = [np.full_like(pictures[0], 255)] * (-len(pictures) % 5)
    rows = [np.concatenate((pictures + blank)[i:i + 5], axis=1) for i in range(0, len(pictures), 5)]
    voxc.save_picture(folder / "picture.png", np.concatenate(rows))
    print(f"{len(list(folder.glob('*.npz')))} meshes in {folder}")


main()
