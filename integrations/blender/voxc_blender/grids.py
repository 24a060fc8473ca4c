"""Volumes as OpenVDB files, which Blender's volumes are read from: by OpenVDB's module for Python where Blender has it, else by the program voxc,
where it was built with OpenVDB."""
import os
import tempfile

import numpy as np

from . import faces
from .module import Refused, voxc

CHUNK = 128


def write(volume, path):
    """Writes two grids: `density`, which is 1 where there is a voxel, and `Cd`, its colour as linear light. Their transform leads to the units of the model."""
    openvdb = _module()
    if openvdb:
        _write_by(openvdb, volume, path)
    else:
        _write_by_program(volume, path)


def _module():
    """Blender calls it openvdb from 4.4 on, and pyopenvdb before; Debian has it in python3-openvdb."""
    for name in ("openvdb", "pyopenvdb"):
        try:
            return __import__(name)
        except ImportError:
            pass
    return None


def _write_by(openvdb, volume, path):
    density, colour = openvdb.FloatGrid(0.0), openvdb.Vec3SGrid((0.0, 0.0, 0.0))
    density.name, colour.name = "density", "Cd"
    density.gridClass = openvdb.GridClass.FOG_VOLUME
    points = volume.points()
    # Boxes that have voxels are copied one at a time, and what is empty there stays without memory.
    boxes = points.places // CHUNK
    order = np.lexsort(boxes.T)
    places, colours, boxes = points.places[order], _linear(faces.colours_of(points)[order, :3]), boxes[order]
    begins = np.flatnonzero(np.append(True, (boxes[1:] != boxes[:-1]).any(axis=1)))
    for begin, end in zip(begins, np.append(begins[1:], len(places))):
        low = boxes[begin] * CHUNK
        x, y, z = (places[begin:end] - low).T
        full, seen = np.zeros((CHUNK,) * 3, np.float32), np.zeros((CHUNK,) * 3 + (3,), np.float32)
        full[x, y, z], seen[x, y, z] = 1, colours[begin:end]
        density.copyFromArray(full, ijk=tuple(map(int, low)))
        colour.copyFromArray(seen, ijk=tuple(map(int, low)))
    # Whole numbers of OpenVDB's are the middles of voxels; its matrices multiply rows from the right.
    to_model = np.vstack([volume.to_model, [0, 0, 0, 1]])
    to_model[:3, 3] += to_model[:3, :3] @ [0.5, 0.5, 0.5]
    for grid in (density, colour):
        grid.transform = openvdb.createLinearTransform(to_model.T.tolist())
    openvdb.write(path, grids=[density, colour])


def _linear(srgb):
    value = srgb / np.float32(255)
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4).astype(np.float32)


def _write_by_program(volume, path):
    from voxc._program import run

    with tempfile.TemporaryDirectory() as scratch:
        file = os.path.join(scratch, "volume.hvx")
        volume.save(file)
        try:
            run(["export", file, "-o", path, "--quiet"])
        except voxc().Error as reason:
            raise Refused(f"Blender has no module for OpenVDB, which Debian has in python3-openvdb, and voxc does not help: {reason}") from None
