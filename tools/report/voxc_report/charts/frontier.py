"""Size against speed with the Pareto frontier."""
from ..frontier import Place
from ..speeds import speed_unit
from ..words import point_note, stage_title
from . import labels as naming
from .drawing import CROWD, HEIGHT, LETTERS, SMALL_LETTERS, Canvas, Mark, Width
from .scales import set_sizes, set_speeds

# Beside another chart, on a telephone, alone on the page; and how many names of points that do not lead would not hide the frontier.
WIDE, NARROW, FULL = Width("wide", 470), Width("narrow", 286), Width("full", 1060)
MOST_OTHERS = {WIDE: 14, NARROW: 4, FULL: 40}
# The share of a name that may cover something; one for which there is no better place is left out.
MOST_COVERED = 0.25
# What a point takes, from its middle.
REACH = 7


def stairs_of(leaders):
    """The corners of the greatest speed that is to be had for a size, but for the last one."""
    x, y = [], []
    for leader in leaders:
        x += [leader.size, leader.size]
        y += [y[-1] if y else 0, leader.speed.median]
    return x, y


def draw_frontier(canvas, leaders):
    """A staircase, and below it what is beaten."""
    x, y = stairs_of(leaders)
    right = canvas.axes.get_xlim()[1]
    x, y = [*x, right], [*y, y[-1]]
    canvas.draw_area("beaten", [*x, right], [*y, 0])
    canvas.draw_line("frontier", x, y)


def stair_boxes(canvas, leaders):
    """Thin boxes along the stairs, which names keep off; to be crossed by a riser harms a name less."""
    boxes, left, bottom = [], 0, HEIGHT
    for leader in leaders:
        x, y = canvas.place(leader.size, leader.speed.median)
        boxes += [(left, bottom - 2, x, bottom + 2), (x - 0.75, y, x + 0.75, bottom)]
        left, bottom = x, y
    return naming.as_boxes([*boxes, (left, bottom - 2, canvas.width.frame, bottom + 2)])


def label_of(canvas, entry):
    return naming.Label(entry.name, *canvas.place(entry.size, entry.speed.median))


def write_label(canvas, placed, name):
    if placed.has_leader:
        canvas.draw_leader(placed.label.x, placed.label.y, *placed.leader_end)
    canvas.draw_label(name, placed.label.text, placed.box[0], placed.baseline, placed.size)


def draw_names(canvas, catalogue, points, leaders):
    """Names of leaders where there is room, then those of points that come closest to the frontier."""
    frame = (4, -4, canvas.width.frame + 14, HEIGHT - 4)
    others = [entry for entry in points if not entry.is_leading]
    leading = [label_of(canvas, entry) for entry in leaders]
    other_boxes = naming.as_boxes([naming.around(*canvas.place(entry.size, entry.speed.median), REACH) for entry in others])
    boxes = [stair_boxes(canvas, leaders), other_boxes]
    for placed in naming.place_labels(leading, frame, LETTERS, naming.numpy.vstack(boxes)):
        if placed.covered < MOST_COVERED * LETTERS * naming.text_width(placed.label.text, LETTERS):
            write_label(canvas, placed, "label")
            boxes.append(placed.box)
    boxes.append(naming.as_boxes([naming.around(label.x, label.y, REACH) for label in leading]))
    others.sort(key=lambda entry: -entry.speed.median / catalogue.rival_of(entry).speed.median)
    for placed in naming.place_where_free([label_of(canvas, entry) for entry in others], frame, SMALL_LETTERS,
                                          naming.numpy.vstack(boxes), MOST_OTHERS[canvas.width]):
        write_label(canvas, placed, "label small")


def marks_of(catalogue, points):
    is_crowded = len(points) > CROWD
    return [Mark(entry.look.family, entry.variant, entry.standing.place.value, point_note(catalogue, entry), entry.row_id,
                 is_small=is_crowded and entry.standing.place is Place.BEATEN, has_errors=entry.has_errors) for entry in points]


def frontier_chart(catalogue, stage, own_range, is_alone):
    """The chart of a stage that has points. `is_alone`: no other stands beside it."""
    points = sorted(stage.points, key=lambda entry: (entry.size, entry.speed.median, entry.variant))
    marks = marks_of(catalogue, points)
    title = f"{stage.model}, {stage_title(stage)}: size against speed"
    drawings = []
    for width in (WIDE, NARROW, FULL) if is_alone else (WIDE, NARROW):
        canvas = Canvas(width)
        set_sizes(canvas.axes, own_range.least_size, own_range.most_size)
        set_speeds(canvas.axes.yaxis, canvas.axes.set_ylim, own_range.most_speed)
        canvas.draw_axes("Size, logarithmic", speed_unit(stage.has_clock))
        draw_frontier(canvas, stage.leaders)
        draw_names(canvas, catalogue, points, stage.leaders)
        canvas.draw_points([(entry.size, entry.speed.median) for entry in points],
                           [(entry.speed.min, entry.speed.max) for entry in points])
        drawings.append(canvas.to_page(title, marks, has_notes=width is WIDE))
    return "".join(drawings)
