"""The plots of voxc accuracy, of its figures: accuracy.svg, lod.svg, and of each series NAME-error.svg and NAME-speed.svg.

docs/bench.md describes the figures.
"""
import json
import os
import sys

from .charts.plots import Axis, Plot, Series
from .problems import Problem
from .output import write

SPEED = "million rays per CPU second"
ERROR = "rays missed, ghost or wrong, per million"
# Of each series the title, and the axis of what is varied.
SERIES = {"distance": ("the distance of the origin", Axis("distance of the origin in voxels", 10)),
          "resolution": ("resolution", Axis("voxels an axis", 2))}


def errors_per_million(error):
    wrong = error["missed"] + error["ghost"] + error["wrong"]
    return 1e6 * wrong / error["rays"] if error["rays"] else 0


def error_axis(error):
    """Errors per million, from where one ray of those checked is wrong."""
    return Axis(ERROR, 10, 1e6 / error["rays"] if error["rays"] else 1)


def note(label, score):
    return (f"{label}: {score['mrays_per_cpu_s']:.4g} million rays per CPU second, {errors_per_million(score['error']):.4g} errors "
            "per million")


def variants_plot(figures, subject):
    series = [Series(variant["label"], [(variant["mrays_per_cpu_s"], errors_per_million(variant["error"]),
                                         note(variant["label"], variant))]) for variant in figures["variants"]]
    return Plot("Speed against error", subject, Axis(SPEED), error_axis(figures["variants"][0]["error"]), series)


def lod_plot(lods, subject):
    labels = [f"{lod['pixels']:g} {'pixel' if lod['pixels'] == 1 else 'pixels'}" for lod in lods]
    series = [Series(label, [(lod["speed_up"], lod["psnr"], label)]) for label, lod in zip(labels, lods)]
    return Plot("Speed of deliberate approximation", subject, Axis("speed-up against full detail"),
                Axis("PSNR against full detail in dB"), series)


def lines(figures, points, value):
    """A line for each variant; `value` takes what is plotted from a score."""
    labels = [variant["label"] for variant in figures["variants"]]
    return [Series(label, [(point["voxels"], value(score), note(label, score))
                           for point in points for score in [point["variants"][i]]]) for i, label in enumerate(labels)]


def series_plots(figures, name, points):
    title, axis = SERIES[name]
    error = points[0]["variants"][0]["error"]
    subject = f"{error['rays']} rays at each place"
    yield name + "-error", Plot("Error against " + title, subject, axis, error_axis(error),
                                lines(figures, points, lambda score: errors_per_million(score["error"])), True)
    yield name + "-speed", Plot("Speed against " + title, subject, axis, Axis(SPEED),
                                lines(figures, points, lambda score: score["mrays_per_cpu_s"]), True)


def plots_of(figures):
    """The plots of what there is, by their names."""
    subject = f"{figures['format']}, {figures['rays']} rays"
    plots = {"accuracy": variants_plot(figures, subject)}
    if figures.get("lods"):
        plots["lod"] = lod_plot(figures["lods"], subject)
    for name, points in figures.get("series", {}).items():
        plots.update(series_plots(figures, name, points))
    return plots


def main():
    """Draws the plots of FOLDER/accuracy.json beside it."""
    folder = sys.argv[1]
    try:
        with open(os.path.join(folder, "accuracy.json"), encoding="utf-8") as file:
            figures = json.load(file)
        for name, plot in plots_of(figures).items():
            write(os.path.join(folder, name + ".svg"), plot.to_svg())
    except Problem as problem:
        print(problem, file=sys.stderr)
        return problem.exit_code
    return 0
