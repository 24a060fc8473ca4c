"""From Matplotlib to a part of a page.

Charts are drawn in pixels of the page. What is drawn has a group id of Matplotlib's, which becomes its class on the page: the
style sheet gives colours and widths, so that a chart is light or dark as the page is. Points become links.
"""
import io
import math
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon
from matplotlib.transforms import IdentityTransform

from ..markup import tag, text_tag

matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "voxc", "path.simplify": False})

HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 300, 44, 18, 34, 44
LETTERS, SMALL_LETTERS = 12.5, 11
CROWD = 60

SVG = "{http://www.w3.org/2000/svg}"
NUMBER = re.compile(r"-?\d+\.\d+")
ANCHOR = re.compile(r"text-anchor: (\w+)")
STROKE = re.compile(r"M[^M]+")
# What XML cannot hold, and what would break a line.
CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029\ufffe\uffff]")


@dataclass(frozen=True)
class Width:
    """A width for which charts are drawn: the class of the drawing, and the frame's pixels."""
    name: str
    frame: int


@dataclass
class Mark:
    """What a point is on the page; points are numbered as they are drawn."""
    family: int
    variant: int  # Points of one variant are shown together.
    style: str  # "on", "good" or "".
    note: str  # Several lines, shown when pointed at or focused; the first is a heading.
    target: str  # The id of the row that its link leads to.
    is_small: bool = False
    has_errors: bool = False


class Canvas:
    """A figure whose frame has so many pixels, with room for what stands beside the axes."""

    def __init__(self, width):
        self.width = width
        self.whole = (width.frame + LEFT + RIGHT, HEIGHT + TOP + BOTTOM)
        self.figure = Figure(figsize=[side / 72 for side in self.whole], dpi=72)
        FigureCanvasSVG(self.figure)
        self.axes = self.figure.add_axes((LEFT / self.whole[0], BOTTOM / self.whole[1], width.frame / self.whole[0],
                                          HEIGHT / self.whole[1]), frameon=False)

    def draw_axes(self, x_name, y_name):
        """Ticks with a line across for each of y, and what the axes are called."""
        axes = self.axes
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_tick_params(length=0, pad=8, labelsize=LETTERS)
            for label in axis.get_ticklabels():
                label.set_gid("tick")
        for y in axes.get_yticks():
            self.draw_line("grid" if y > 0 else "axis", [0, 1], [y, y], axes.get_yaxis_transform())
        for x in axes.get_xticks():
            self.draw_line("axis", [x, x], [0, -5 / HEIGHT], axes.get_xaxis_transform())
        self.write("unit", "↑ " + y_name, LEFT - 40, TOP - 14)
        self.write("unit", x_name + " →", self.whole[0] - RIGHT, TOP + HEIGHT + 38, anchor="right")

    def draw_line(self, name, x, y, transform=None):
        self.add(Line2D(x, y, gid=name, transform=transform or self.axes.transData))

    def draw_area(self, name, x, y):
        self.add(Polygon(list(zip(x, y)), gid=name, transform=self.axes.transData))

    def add(self, artist):
        """Draws something as it is: nothing else that Matplotlib would do for it has an effect here."""
        artist.set_clip_on(False)
        self.axes.add_artist(artist)

    def draw_points(self, places, rounds=()):
        """The points of the page, with the rounds of each from the slowest to the fastest, as far as the axis reaches."""
        top = self.axes.get_ylim()[1]
        if rounds:
            x = [x for x, _ in places for x in (x, x, math.nan)]
            self.draw_line("rounds", x, [y for least, most in rounds for y in (least, min(most, top), math.nan)])
        x, y = zip(*places)
        self.add(Line2D(x, y, marker="o", linestyle="", gid="points", transform=self.axes.transData))

    def draw_leader(self, x, y, to_x, to_y):
        self.draw_line("leader", [LEFT + x, LEFT + to_x], [self.up(y), self.up(to_y)], IdentityTransform())

    def draw_label(self, name, text, x, y, size):
        """Text whose baseline begins at a place in the frame, from its top left corner."""
        self.write(name, text, LEFT + x, TOP + y, size)

    def write(self, name, text, x, y, size=LETTERS, anchor="left"):
        text = CONTROL.sub(" ", text)
        self.figure.text(x, self.whole[1] - y, text, gid=name, size=size, ha=anchor, va="baseline", transform=IdentityTransform(),
                         parse_math=False)

    def up(self, y):
        """A place in the frame as Matplotlib counts it, from the bottom."""
        return self.whole[1] - TOP - y

    def place(self, x, y):
        """Where a value lies, in pixels from the frame's top left corner."""
        across, up = self.axes.transData.transform((x, y))
        return across - LEFT, self.up(0) - up

    def to_page(self, title, marks, has_notes):
        """The chart as an svg element. `has_notes`: points hold what is to be told of them."""
        file = io.StringIO()
        self.figure.savefig(file, format="svg", metadata={"Date": None})
        root = xml.fromstring(file.getvalue())
        crowd = " crowded" if len(marks) > CROWD else ""
        content = text_tag("title", {}, title) + "".join(page_elements(root, marks, has_notes))
        return tag("svg", {"class": f"chart {self.width.name}{crowd}", "viewBox": f"0 0 {self.whole[0]} {self.whole[1]}",
                           "role": "group"}, content)


def rounded(text):
    """Places to a tenth of a pixel."""
    return NUMBER.sub(lambda number: f"{float(number[0]):.1f}".removesuffix(".0"), text)


def outline(path):
    return rounded("".join(path.get("d").split("\n")).strip())


def named_groups(root):
    """The groups of what was drawn with a name, in the order in which it was drawn."""
    for group in root.iter(SVG + "g"):
        if "_" not in group.get("id", "_"):  # Matplotlib's own ids are such as "line2d_3".
            yield group.get("id"), group


def page_elements(root, marks, has_notes):
    """What was drawn, as elements of a page; points last, those of the frontier on top."""
    places, rounds = [], len(marks) * [None]
    for name, group in named_groups(root):
        if name == "points":
            places = [{"x": rounded(use.get("x")), "y": rounded(use.get("y"))} for use in group.iter(SVG + "use")]
        elif name == "rounds":
            rounds = STROKE.findall(outline(group.find(SVG + "path")))
        else:
            yield from named_elements(name, group)
    points = list(zip(marks, places, rounds, strict=True))
    for style in ("", "good", "on"):
        yield from (point_element(*point, has_notes) for point in points if point[0].style == style)


def named_elements(name, group):
    """Lines, areas and text of one name."""
    for path in group.iter(SVG + "path"):
        yield tag("path", {"class": name, "d": outline(path)}, "")
    for text in group.iter(SVG + "text"):
        anchor = ANCHOR.search(text.get("style"))
        end = {"text-anchor": anchor[1]} if anchor and anchor[1] != "start" else {}
        yield text_tag("text", {"class": name, "x": rounded(text.get("x")), "y": rounded(text.get("y")), **end}, text.text or "")


def point_element(mark, place, rounds, has_notes):
    content = text_tag("title", {}, mark.note) if has_notes else ""
    if rounds:
        content += tag("path", {"class": "rounds", "d": rounds}, "")
    if mark.has_errors:
        content += tag("circle", {"class": "ring", "cx": place["x"], "cy": place["y"], "r": 10}, "")
    content += tag("use", {"href": f"#{'s' if mark.is_small else 'm'}{mark.family}", **place}, "")
    style = " ".join(filter(None, ["point", f"f{mark.family}", mark.style]))
    return tag("a", {"class": style, "href": "#" + mark.target, "data-variant": mark.variant}, content)
