"""Kinds of rays that scripts measure: of a camera and in random directions, from near (1.5 edges, or from within) and from 300 edges away."""
import os
import subprocess

import numpy as np

FAR = 300


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def camera(edge, eye, count):
    """A picture that the scene fills, from any distance."""
    middle = np.full(3, edge / 2)
    forward = unit(middle - eye)
    right = unit(np.cross(forward, [0, 1, 0]))
    up = np.cross(right, forward)
    width = round(count**0.5)
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-0.9, 0.9, width)]), -1).reshape(-1, 2)
    half = 0.6 * edge / np.linalg.norm(middle - eye)
    direction = forward + half * (grid[:, :1] * right + grid[:, 1:] * up)
    return np.tile(eye, (len(direction), 1)), direction


def scattered(edge, origins, random):
    """From these, by chance to a point of the scene, or, where they are in it, in any direction."""
    to = random.uniform(0, edge, (len(origins), 3))
    inside = np.all((origins >= 0) & (origins < edge), axis=1, keepdims=True)
    return origins, np.where(inside, random.normal(size=to.shape), to - origins)


def kinds(edge, count):
    random = np.random.default_rng(5)
    aside = np.array([0.6, 0.35, 0.72]) * edge
    sphere = edge / 2 + FAR * edge * unit(random.normal(size=(count, 3)))
    return {
        "near, a camera": camera(edge, edge / 2 + 1.5 * aside, count),
        "near, scattered": scattered(edge, random.uniform(0, edge, (count, 3)), random),
        "far, a camera": camera(edge, edge / 2 + FAR * aside, count),
        "far, scattered": scattered(edge, sphere, random),
    }


def write(file, origins, directions):
    np.concatenate([origins, directions], 1).astype("<f4").tofile(file)
    return file


def write_kinds(folder, edge, count):
    return {kind: write(folder / f"{number}.rays", *rays) for number, (kind, rays) in enumerate(kinds(edge, count).items())}


def run(*command, folder):
    """One thread, and kernels that lavapipe compiled once."""
    environment = {**os.environ, "LP_NUM_THREADS": "1", "MESA_SHADER_CACHE_DIR": str(folder / "mesa")}
    subprocess.run([str(part) for part in command], check=True, env=environment, stdout=subprocess.DEVNULL)
