#!/usr/bin/env python3
"""Fits the weights of a speed model (lib/Search/SpeedModel.cpp) to what was measured, and tells how well it predicts.

  fit-speeds.py FOLDER...    folders of one device, of: voxc search INPUT --formats LIST --all -o FOLDER --stats FOLDER/stats.json

Of a cell that several folders have measured the fastest round counts, as other work on a machine only slows it. The weights
have the least sum of squared relative errors, none below 0, as those that voxc search fits. Errors are told as fitted, of
formats that were left out of the fit, and of scenes that were; the rank correlation is that of scenes that were left out.
"""
import json
import sys
from pathlib import Path

import numpy as np

SWEEPS = 2000
FOLDS = 8


def samples(folders):
    """(scene, rays, format): [terms of the model, nanoseconds a ray]."""
    found = {}
    for folder in map(Path, folders):
        rated = {(f["format"], *f["passes"]): f["rays"] for f in json.loads((folder / "stats.json").read_text())["formats"]}
        for line in (folder / "results.jsonl").read_text().splitlines():
            record = json.loads(line)
            if record["status"] != "measured":
                continue
            rays, name = record["rays"]["name"], (record["format"]["name"], *record["format"]["passes"])
            nanoseconds = 1000 / record["speed"]["mrays_per_cpu_s"]["max"]
            sample = found.setdefault((record["model"]["name"], rays, name), [rated[name][rays]["terms"], nanoseconds])
            sample[1] = min(sample[1], nanoseconds)
    return found


def fit(terms):
    """Weights with which each row of terms, divided by its time, is nearest to 1: by coordinate descent."""
    products, targets = terms.T @ terms, terms.sum(axis=0)
    weights = np.zeros(len(targets))
    for _ in range(SWEEPS):
        for i in np.flatnonzero(products.diagonal()):
            weights[i] = max(0, weights[i] + (targets[i] - products[i] @ weights) / products[i, i])
    return weights


def left_out(terms, groups):
    """What is predicted of each row by the fit to all other groups."""
    predicted = np.empty(len(terms))
    for group in set(groups):
        chosen = groups == group
        predicted[chosen] = terms[chosen] @ fit(terms[~chosen])
    return predicted


def rank_correlation(one, other):
    return np.corrcoef(*(np.argsort(np.argsort(values)) for values in (one, other)))[0, 1]


def main(folders):
    found = samples(folders)
    times = np.array([nanoseconds for _, nanoseconds in found.values()])
    terms = np.array([parts for parts, _ in found.values()]) / times[:, None]
    scenes = np.array([scene for scene, _, _ in found])
    texts = sorted({name[0] for _, _, name in found})  # Whatever the passes are that a scene asks for.
    folds = dict(zip(texts, np.random.RandomState(1).permutation(len(texts)) % FOLDS))
    by_format = left_out(terms, np.array([folds[name[0]] for _, _, name in found]))
    by_scene = left_out(terms, scenes)
    weights = fit(terms)

    print(f"{len(found)} speeds of {len(texts)} formats; weights: " + ", ".join(f"{weight:.2g}" for weight in weights))
    for what, predicted in (("as fitted", terms @ weights), ("formats left out", by_format), ("scenes left out", by_scene)):
        errors = np.abs(predicted - 1)
        print(f"{what}: median {np.median(errors):.1%}, nine in ten below {np.percentile(errors, 90):.0%}")
    for scene, rays in sorted({(scene, rays) for scene, rays, _ in found}):
        chosen = np.array([key[:2] == (scene, rays) for key in found])
        print(f"{scene}, {rays}: rank correlation {rank_correlation(by_scene[chosen] * times[chosen], times[chosen]):.2f}")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
