"""What a search predicted beside what was measured: a chart a stage, and how right it was in words."""
from ..charts.prediction import prediction_chart
from ..markup import fill, tag, text_tag
from ..predictions import median_error, predictions_of, rank_correlation, word_predictions_of
from ..text import count_text, number_text, percent_text, plural
from ..words import stage_title


def speed_sentence(predictions):
    order = rank_correlation(predictions)
    return (f"{plural(len(predictions), 'speed')}: median error {percent_text(median_error(predictions))}"
            + ("" if order is None else f", rank correlation {number_text(order)}") + ".")


def word_sentence(words):
    if words.all == 0:
        return ""
    if words.exact == words.all:
        return f" All {plural(words.all, 'size')} are as predicted, to the word."
    return (f" Of {plural(words.all, 'size')} {count_text(words.exact)} are as predicted, to the word; the others are off by "
            f"{plural(words.worst, 'word')} at most.")


def worst_sentence(predictions):
    """Who was misjudged most, for a reader who wants to know where not to trust it."""
    worst = max(predictions, key=lambda prediction: prediction.error)
    return (f" Furthest off: {worst.entry.name}, {number_text(worst.predicted)} predicted and {number_text(worst.measured)} "
            "measured.")


def figure(catalogue, stage):
    predictions = predictions_of(stage)
    if len(predictions) < 2:
        return ""
    words = speed_sentence(predictions) + word_sentence(word_predictions_of(stage)) + worst_sentence(predictions)
    caption = tag("figcaption", {}, text_tag("b", {}, f"{stage.model}, {stage_title(stage)}"))
    return tag("figure", {"class": "stage prediction"}, caption + prediction_chart(catalogue, stage, predictions)
               + text_tag("p", {"class": "remarks"}, words)) + "\n"


def prediction_section(catalogue):
    """Speeds and sizes that a search predicted beside those that were measured."""
    content = "".join(figure(catalogue, stage) for stage in catalogue.stages)
    return fill("section/predictions.html", content=content) if content else ""
