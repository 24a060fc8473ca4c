"""Plots that stand alone, as SVG that is light or dark as its reader's screen is."""
import io
import math
import re
from dataclasses import dataclass

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from ..markup import text_tag

matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "voxc", "font.family": "sans-serif"})

WIDTH, HEIGHT = 800, 560
# What is drawn in a colour of the first scheme is shown in that of the second where the screen is dark. Those of series keep apart in
# both, and for the colour-blind (after Okabe and Ito).
COLOURS = {
    "paper": ("#ffffff", "#0d1117"), "ink": ("#1c2128", "#e6edf3"), "dim": ("#59636e", "#9da7b3"), "grid": ("#dfe3e8", "#2b323b"),
    "c0": ("#0067a8", "#58b4ee"), "c1": ("#c14a00", "#ff9350"), "c2": ("#007f5c", "#3ecf9f"), "c3": ("#a8457f", "#ee8fc6"),
    "c4": ("#8a6a00", "#e3c04a"), "c5": ("#2b8fc4", "#9ad4f5")}
SERIES_COLOURS, MARKS = 6, "os^Dv"
INK, DIM, GRID = (COLOURS[name][0] for name in ("ink", "dim", "grid"))
LETTERS = 14
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
POINT = re.compile(r'<g id="point-(\d+)">')
FONT = re.compile(r"(font: (?:\w+ )?\d+(?:\.\d+)?px )'[^;\"]*")


@dataclass
class Axis:
    label: str  # With its unit.
    base: int = 0  # Of the powers whose distance is the same; 0: linear, from 0.
    least: float = 0  # The smallest value that can occur beside 0; then both have a place.


@dataclass
class Series:
    label: str
    points: list  # Of x, y and a note, which is shown when pointed at; from left to right if they are connected.


@dataclass
class Plot:
    title: str
    subtitle: str
    x: Axis
    y: Axis
    series: list
    connected: bool = False

    def to_svg(self):
        """The document. Points without a value are left out."""
        figure = Figure(figsize=(WIDTH / 72, HEIGHT / 72), dpi=72)
        FigureCanvasSVG(figure)
        axes = figure.add_axes((0.08, 0.12, 0.89, 0.6))
        notes = []
        for index, series in enumerate(self.series):
            draw_series(axes, index, series, self.connected, notes)
        points = [point for series in self.series for point in series.points if None not in point]
        set_axis(axes, "x", self.x, [x for x, _, _ in points])
        set_axis(axes, "y", self.y, [y for _, y, _ in points])
        draw_frame(figure, axes, self)
        file = io.StringIO()
        figure.savefig(file, format="svg", transparent=True, metadata={"Date": None})
        return for_both_schemes(file.getvalue(), notes, self.title)


def draw_series(axes, index, series, connected, notes):
    points = [point for point in series.points if None not in point]
    style = {"color": COLOURS[f"c{index % SERIES_COLOURS}"][0], "marker": MARKS[index % len(MARKS)]}
    if connected:
        axes.plot([x for x, _, _ in points], [y for _, y, _ in points], color=style["color"], linewidth=2.5)
    for x, y, note in points:
        axes.plot([x], [y], markersize=8 if connected else 11, gid=f"point-{len(notes)}", linestyle="", clip_on=False, **style)
        notes.append(note)
    axes.plot([], [], label=series.label, linewidth=2.5 if connected else 0, markersize=8, **style)


def power_text(value):
    """"10", "100", "10³", "10⁻⁵"."""
    exponent = round(math.log10(value)) if value > 0 else 0
    return f"{value:g}" if -2 <= exponent <= 2 else "10" + str(exponent).translate(SUPERSCRIPTS)


def set_axis(axes, which, axis, values):
    """The scale of an axis: linear from 0, or by powers, with a place for 0 if it has one."""
    set_scale, set_limits = getattr(axes, f"set_{which}scale"), getattr(axes, f"set_{which}lim")
    if axis.least > 0:
        set_scale("symlog", base=axis.base, linthresh=axis.least, linscale=0.5)
        set_limits(0, axis.base * max([axis.least, *values]))
    elif axis.base:
        set_scale("log", base=axis.base)
    else:
        set_limits(0, 1.05 * max([1e-9, *values]))
    text = power_text if axis.base == 10 else "{:,.6g}".format
    getattr(axes, which + "axis").set_major_formatter(FuncFormatter(lambda value, _: text(value)))


def draw_frame(figure, axes, plot):
    axes.grid(color=GRID)
    axes.set_axisbelow(True)
    axes.minorticks_off()
    axes.tick_params(colors=DIM, labelsize=LETTERS, length=0, pad=6)
    for name, spine in axes.spines.items():
        spine.set_visible(name in ("left", "bottom"))
        spine.set_color(DIM)
    axes.set_xlabel(plot.x.label, color=INK, size=LETTERS)
    axes.set_title(plot.y.label, color=INK, size=LETTERS, loc="left", pad=10)
    figure.text(0.02, 0.95, plot.title, color=INK, size=18, weight="bold", parse_math=False)
    figure.text(0.02, 0.905, plot.subtitle, color=DIM, size=LETTERS - 1, parse_math=False)
    figure.legend(loc="upper left", bbox_to_anchor=(0.01, 0.89), ncols=3, frameon=False, fontsize=LETTERS, labelcolor=INK)


def style_sheet():
    light, dark = ("".join(f"--{name}:{pair[scheme]};" for name, pair in COLOURS.items()) for scheme in (0, 1))
    return f"svg{{{light}background:var(--paper)}}@media(prefers-color-scheme:dark){{svg{{{dark}}}}}"


def for_both_schemes(svg, notes, title):
    """What Matplotlib drew, with variables in the place of colours, and notes at the points."""
    for name, (light, _) in COLOURS.items():
        svg = svg.replace(light, f"var(--{name})")
    svg = FONT.sub(r"\1system-ui, sans-serif", svg)
    svg = POINT.sub(lambda place: place[0] + text_tag("title", {}, notes[int(place[1])]), svg)
    svg = svg.replace(f'width="{WIDTH}pt" height="{HEIGHT}pt"', f'width="{WIDTH}" role="img"')
    head, rest = svg.split("<metadata>", 1)
    return head + text_tag("title", {}, title) + f"<style>{style_sheet()}</style>" + rest.split("</metadata>", 1)[1]
