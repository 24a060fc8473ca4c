"""Figures as people read them."""
import math

UNITS = ["B", "KiB", "MiB", "GiB", "TiB"]


def number_text(value):
    """Three digits that count, without exponents: "0.0312", "4.74", "1230"."""
    if value == 0:
        return "0"
    magnitude = math.floor(math.log10(abs(value)))
    return f"{value:.{min(max(2 - magnitude, 0), 9)}f}"


def count_text(value):
    """A whole number in groups of three: "1,440,000"."""
    return f"{value:,.0f}"


def in_unit(count):
    """A count of bytes in the unit that suits it, and the unit."""
    unit = 0
    while count >= 1024 and unit + 1 < len(UNITS):
        count /= 1024
        unit += 1
    return count, UNITS[unit]


def bytes_text(count):
    """"12.3 MiB"."""
    value, unit = in_unit(count)
    return f"{number_text(value)} {unit}"


def whole_bytes_text(count):
    """"16 MiB", for powers of two."""
    value, unit = in_unit(count)
    return f"{count_text(value)} {unit}"


def percent_text(share):
    return f"{100 * share:.1f} %"


def plural(count, noun):
    """"1 format", "20 formats"."""
    return f"{count_text(count)} {noun}{'' if count == 1 else 's'}"
