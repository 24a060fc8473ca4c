"""How well what a search predicted came true."""
import statistics
from typing import NamedTuple

from .catalogue import Entry
from .speeds import MOST_SPEED


class Prediction(NamedTuple):
    """A speed that was predicted and measured, both in what the device counts."""
    entry: Entry
    predicted: float
    measured: float

    @property
    def error(self):
        """By what share of the measured speed the other one is off."""
        return abs(self.predicted - self.measured) / self.measured


class Words(NamedTuple):
    """Sizes that were predicted and built."""
    all: int
    exact: int
    worst: int  # The largest difference in words.


def predictions_of(stage):
    """Those of a stage, in the order of its entries."""
    predicted = [(entry, entry.record.get("predicted", {}).get("mrays_per_s", 0)) for entry in stage.points]
    return [Prediction(entry, speed, entry.speed.median) for entry, speed in predicted if 0 < speed < MOST_SPEED]


def median_error(predictions):
    return statistics.median([prediction.error for prediction in predictions] or [0])


def ranks(values):
    """The rank of each value from 1 up; equal values have the mean of their ranks."""
    order = sorted(values)
    first = {value: place for place, value in reversed(list(enumerate(order)))}
    last = {value: place for place, value in enumerate(order)}
    return [(first[value] + last[value]) / 2 + 1 for value in values]


def rank_correlation(predictions):
    """Spearman's: 1 if the order came true. None if either side has fewer than two different values."""
    predicted = ranks([prediction.predicted for prediction in predictions])
    measured = ranks([prediction.measured for prediction in predictions])
    if len(set(predicted)) < 2 or len(set(measured)) < 2:
        return None
    return statistics.correlation(predicted, measured)


def word_predictions_of(stage):
    found = [abs(entry.record["predicted"]["words"] - entry.record["volume"]["words"]) for entry in stage.entries
             if "words" in entry.record.get("predicted", {}) and "words" in entry.record["volume"]]
    return Words(len(found), found.count(0), max(found, default=0))
