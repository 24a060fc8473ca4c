"""Speeds of several rounds, in million rays a second."""
from typing import NamedTuple

MOST_SPEED = 1e12


class Speed(NamedTuple):
    min: float
    median: float
    max: float
    spread: float  # (max - min) / median.


def are_equal(a, b):
    """Whether the medians differ by no more than the wider of the two ranges."""
    return abs(a.median - b.median) <= max(a.max - a.min, b.max - b.min)


def is_drawable(speed):
    """Whether it is one that a machine may have; what is computed of it stays finite."""
    return 1e-12 <= speed.median <= MOST_SPEED and 0 <= speed.spread <= 1e6


def in_order(speed):
    """The rounds in order, whatever a record says of them."""
    return speed._replace(min=min(max(speed.min, 0), speed.median), max=min(max(speed.max, speed.median), MOST_SPEED))


def counts_own_time(record):
    """Whether speeds count in timestamps of the device, and not in CPU seconds of the process."""
    return record["device"]["clock"] == "gpu"


def speed_of(record):
    """The speed that counts: per CPU second, or per second of the device. None if there is none, or an absurd one."""
    figures = record["speed"].get("mrays_per_device_s" if counts_own_time(record) else "mrays_per_cpu_s")
    if "failure" in record or figures is None:
        return None
    speed = Speed(*(float(figures[name]) for name in Speed._fields))
    return in_order(speed) if is_drawable(speed) else None


def speed_unit(has_clock):
    return "Mrays/GPU s" if has_clock else "Mrays/CPU s"
