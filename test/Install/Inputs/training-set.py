"""training-set.py FILE...: the depths of a training set are those that its places have, and the normals are of length 1 or 0"""
import sys

import numpy as np

for path in sys.argv[1:]:
    data = np.load(path)
    places, normals, depths = data["places"], data["normals"], data["depths"]
    assert places.dtype == np.int32 and len(places) == len(normals) and depths.shape == (6, 64, 64), path
    lengths = np.linalg.norm(normals, axis=-1)
    assert np.all(np.isclose(lengths, 1) | (lengths == 0)) and np.any(lengths > 0), path
    for axis in range(3):
        others = [other for other in range(3) if other != axis]
        first, last = np.full((64, 64), 64), np.full((64, 64), -1)
        np.minimum.at(first, tuple(places[:, others].T), places[:, axis])
        np.maximum.at(last, tuple(places[:, others].T), places[:, axis])
        seen = last >= 0
        np.testing.assert_array_equal(depths[2 * axis], np.where(seen, first + 1, 0))  # From -1 on.
        np.testing.assert_array_equal(depths[2 * axis + 1], np.where(seen, 64 - last, 0))  # From 65 on, to the far side.
    print("all depths are those of the places")
