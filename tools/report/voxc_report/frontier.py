"""The Pareto frontier: formats that no other beats in both size and speed, and what the rounds can tell of it."""
from enum import Enum
from typing import NamedTuple

from .speeds import are_equal

# A size that is larger by no more than this share is hardly larger.
HARDLY_LARGER = 0.01


class Place(Enum):
    LEADING = "on"  # On the frontier: measurably faster than all that are at least as small.
    AS_GOOD = "good"  # No measured difference from one that leads: as fast, and hardly larger.
    BEATEN = ""  # One that leads is smaller and at least as fast, or as small and faster.


class Standing(NamedTuple):
    place: Place
    rival: int  # The fastest leader that is at least as small; of a leader itself.


def sweep_order(points):
    """From small to large, and of equally large ones from fast to slow."""
    return sorted(range(len(points)), key=lambda i: (points[i][0], -points[i][1].median))


def standings(points):
    """The standing of each pair of bytes and speed. Of the frontier of the medians those lead that differ from the leader
    before them by more than their rounds do; the smallest always leads."""
    result = [None] * len(points)
    best, leader = None, None
    for i in sweep_order(points):
        size, speed = points[i]
        is_on = best is None or (size, speed.median) == best or speed.median > best[1]
        if is_on:
            best = (size, speed.median)
        is_as_fast = leader is not None and are_equal(speed, points[leader][1])
        if is_on and not is_as_fast:
            leader = i
        is_hardly_larger = size <= points[leader][0] * (1 + HARDLY_LARGER)
        place = Place.LEADING if leader == i else Place.AS_GOOD if is_as_fast and is_hardly_larger else Place.BEATEN
        result[i] = Standing(place, leader)
    return result
