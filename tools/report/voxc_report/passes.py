"""Passes in names: those that most cells have are told once, and a name says where it differs from them."""
from collections import Counter


def common_passes(lists):
    """The passes that more than half of the lists have, in the order in which they first came."""
    counts = Counter(name for passes in lists for name in passes)
    return [name for name, count in counts.items() if 2 * count > len(lists)]


def pass_difference(passes, common):
    """" +restart-sv −whole-level-dedup": what a list has beside the most common one, and what it lacks of it."""
    return "".join([f" +{name}" for name in passes if name not in common] +
                   [f" −{name}" for name in common if name not in passes])


def pass_list(passes):
    return ", ".join(passes)
