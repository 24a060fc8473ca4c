"""Pairs of cells that differ in one thing alone: a pass, or the precision."""
from typing import NamedTuple

from .catalogue import Entry
from .speeds import are_equal


class Pair(NamedTuple):
    with_it: Entry
    without: Entry

    @property
    def shrinkage(self):
        """How many times as small the volume is with it; None if a size is not known."""
        both = self.with_it.size and self.without.size
        return self.without.size / self.with_it.size if both else None

    @property
    def speed_up(self):
        """How many times as fast it is with it; None if a speed is not known."""
        both = self.with_it.speed and self.without.speed
        return self.with_it.speed.median / self.without.speed.median if both else None

    @property
    def is_as_fast(self):
        return self.speed_up is not None and are_equal(self.with_it.speed, self.without.speed)


def identity(entry, precision, passes):
    """What must be the same for both."""
    return entry.model, entry.column, entry.look.name, entry.device, precision, entry.resolution, tuple(passes)


def pairs(catalogue, has_it, lacks_it, key):
    """Measured cells that have a thing, each beside the one that lacks it and is the same in all else, as `key` tells that."""
    without = {}
    for entry in catalogue.entries:
        if entry.is_measured and lacks_it(entry):
            without.setdefault(key(entry), entry)
    return [Pair(entry, without[key(entry)]) for entry in catalogue.entries
            if entry.is_measured and has_it(entry) and key(entry) in without]


def pairs_by_pass(catalogue, name):
    return pairs(catalogue, lambda entry: name in entry.passes, lambda entry: name not in entry.passes,
                 lambda entry: identity(entry, entry.precision, [other for other in entry.passes if other != name]))


def pairs_by_precision(catalogue):
    """Cells of precision fast beside exact ones."""
    return pairs(catalogue, lambda entry: entry.precision == "fast", lambda entry: entry.precision == "exact",
                 lambda entry: identity(entry, None, entry.passes))
