"""What axes show: sizes by powers of two, speeds from 0; the same for charts that stand side by side to be compared."""
import math
from dataclasses import dataclass

from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator

# A round that is faster than all medians by more than this is drawn cut off.
MOST_ABOVE_MEDIANS = 1.25
# How many times as fast the best of one chart may be as that of another with the same axis.
MOST_APART = 3
# The names of the smallest stand to their left.
ROOM_FOR_NAMES = 1.7
TICKS = 5
UNITS = ["B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"]


@dataclass
class Range:
    least_size: float
    most_size: float
    most_speed: float  # The speeds begin at 0.


def own_range(stage):
    """What the points of one stage take."""
    sizes = [entry.size for entry in stage.points]
    median = max((entry.speed.median for entry in stage.points), default=0)
    fastest = max((entry.speed.max for entry in stage.points), default=0)
    return Range(min(sizes, default=math.inf), max(sizes, default=0), min(fastest, MOST_ABOVE_MEDIANS * median))


def share_sizes(ranges):
    least, most = min(own.least_size for own in ranges), max(own.most_size for own in ranges)
    for own in ranges:
        own.least_size, own.most_size = least, most


def share_speeds(ranges):
    """From the fastest down, each takes the axis of the one before it unless that is too long for it."""
    most = math.inf
    for own in sorted(ranges, key=lambda own: -own.most_speed):
        if most > MOST_APART * own.most_speed:
            most = own.most_speed
        own.most_speed = most


def ranges_of(stages):
    """The range of each stage. Stages of one model and resolution have the sizes in common. Those whose speeds count in the same
    have the speeds in common too, unless they are so far apart that the slower ones would lie flat on the axis."""
    ranges = [own_range(stage) for stage in stages]
    by_size, by_speed = {}, {}
    for stage, own in zip(stages, ranges):
        by_size.setdefault((stage.model, stage.resolution), []).append(own)
        by_speed.setdefault((stage.model, stage.resolution, stage.has_clock), []).append(own)
    for group in by_size.values():
        share_sizes(group)
    for group in by_speed.values():
        share_speeds(group)
    return ranges


def power_text(exponent):
    """"512 KiB" for 2^19."""
    unit = min(max(exponent // 10, 0), len(UNITS) - 1)
    return f"{2.0 ** (exponent - 10 * unit):g} {UNITS[unit]}"


def set_sizes(axes, least, most):
    """The x axis: whole powers of two, at most as many ticks as have room."""
    low = math.floor(math.log2(least / ROOM_FOR_NAMES))
    high = max(math.ceil(math.log2(most)), low + 1)
    step = max(1, math.ceil((high - low) / TICKS))
    axes.set_xscale("log", base=2)
    axes.set_xlim(2.0**low, 2.0**high)
    axes.xaxis.set_major_locator(FixedLocator([2.0**exponent for exponent in range(low, high + 1, step)]))
    axes.xaxis.set_minor_locator(FixedLocator([]))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda size, _: power_text(round(math.log2(size)))))


def set_speeds(axis, set_limits, most):
    """An axis from 0 to the first round number above the fastest."""
    ticks = MaxNLocator(TICKS, steps=[1, 2, 5, 10]).tick_values(0, (most or 1) * 1.05)
    ticks = [tick for tick in ticks if tick >= 0]
    set_limits(0, ticks[-1])
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(FuncFormatter(lambda speed, _: f"{speed:g}"))
