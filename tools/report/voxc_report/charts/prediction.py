"""Speeds that a search predicted against those that were measured."""
from ..speeds import speed_unit
from ..text import number_text, percent_text
from ..words import standing_words, stage_title
from .drawing import CROWD, Canvas, Mark
from .frontier import NARROW, WIDE
from .scales import set_speeds

# Points of the band differ by no more than this share of the measured speed.
BAND = 0.1


def note(catalogue, prediction):
    return (f"{prediction.entry.name}\n{number_text(prediction.predicted)} predicted, {number_text(prediction.measured)} measured: "
            f"off by {percent_text(prediction.error)}\n{standing_words(catalogue, prediction.entry)}")


def draw_band(canvas):
    """The line on which speeds are as they were predicted, and what lies close to it."""
    most = canvas.axes.get_ylim()[1]
    canvas.draw_area("beaten", [0, most * (1 - BAND), most, most], [0, most, most, most / (1 + BAND)])
    canvas.draw_line("frontier", [0, most], [0, most])


def prediction_chart(catalogue, stage, predictions):
    most = max(max(prediction.predicted, prediction.measured) for prediction in predictions)
    is_crowded = len(predictions) > CROWD
    marks = [Mark(prediction.entry.look.family, prediction.entry.variant, "on" if prediction.entry.is_leading else "",
                  note(catalogue, prediction), prediction.entry.row_id, is_small=is_crowded) for prediction in predictions]
    drawings = []
    for width in (WIDE, NARROW):
        canvas = Canvas(width)
        set_speeds(canvas.axes.xaxis, canvas.axes.set_xlim, most)
        set_speeds(canvas.axes.yaxis, canvas.axes.set_ylim, most)
        canvas.draw_axes("predicted", speed_unit(stage.has_clock) + " measured")
        draw_band(canvas)
        canvas.draw_points([(prediction.predicted, prediction.measured) for prediction in predictions])
        drawings.append(canvas.to_page(f"{stage_title(stage)}: speeds predicted and measured", marks, has_notes=width is WIDE))
    return "".join(drawings)
