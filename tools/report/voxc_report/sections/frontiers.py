"""The frontiers of all models side by side: which formats are worth having everywhere."""
from ..markup import fill, table_row, tag, text_tag
from ..text import count_text
from ..words import side_text, common_words

# A search has hundreds of formats that are on no frontier.
MOST_NAMES = 30
# The class of a format's mark on a model, the words shown when it is pointed at, and the mark.
ON, GOOD, OFF = ("on", "on the frontier", "●"), ("good", "as good as the frontier", "≈"), ("off", "dominated", "·")
FAILED = ("failed", "failed", "failed")


def rounds_of(catalogue):
    """Stages that differ in the model alone, of two models at least."""
    rounds = {}
    for stage in catalogue.stages:
        if stage.points:
            rounds.setdefault((stage.resolution, stage.device, stage.precision), []).append(stage)
    return [stages for stages in rounds.values() if len(stages) > 1]


def entry_of(stage, variant):
    return next((entry for entry in stage.entries if entry.variant == variant), None)


def dot(entry):
    if entry is None:
        return tag("td", {}, "")
    name, words, mark = (FAILED if not entry.has_point else ON if entry.is_leading else GOOD if entry.is_as_good else OFF)
    return text_tag("td", {"class": name, "title": words}, mark)


class Row:
    """A format with its passes in one round."""

    def __init__(self, stages, variant):
        entries = [entry_of(stage, variant) for stage in stages]
        known = [entry for entry in entries if entry]
        self.name = known[-1].name
        self.dots = "".join(map(dot, entries))
        self.wins = sum(entry.is_leading or entry.is_as_good for entry in known)
        self.is_everywhere = self.wins == len(stages)

    def to_html(self):
        return table_row([text_tag("th", {"scope": "row"}, self.name), self.dots],
                         **{"class": "always" if self.is_everywhere else ""})


def rows_of(stages):
    """Formats that win most first, others in their order."""
    variants = sorted({entry.variant for stage in stages for entry in stage.entries})
    return sorted((Row(stages, variant) for variant in variants), key=lambda row: -row.wins)


def names_text(rows):
    names = [row.name for row in rows]
    more = f" and {count_text(len(names) - MOST_NAMES)} more" if len(names) > MOST_NAMES else ""
    return ", ".join(names[:MOST_NAMES]) + more


def conditions(stages):
    """"exact steps; whole-level-dedup, unless a name says otherwise"."""
    first = stages[0]
    return (f"{first.precision} steps; " if first.precision else "") + common_words(
        first.common_passes, any(stage.has_other_passes for stage in stages))


def round_html(stages):
    rows, first = rows_of(stages), stages[0]
    winners, losers = [row for row in rows if row.is_everywhere], [row for row in rows if row.wins == 0]
    sentence = (f"On the frontier of every model: {names_text(winners)}." if winners
                else "No format is on the frontier of every model.")
    caption = (text_tag("b", {}, f"{side_text(first.resolution)} on {first.device}") + " " + text_tag("span", {}, conditions(stages))
               + text_tag("p", {}, sentence))
    head = "".join(text_tag("th", {"scope": "col"}, name) for name in ["Format", *(stage.column for stage in stages)])
    body = "".join(row.to_html() for row in rows if row.wins)
    table = tag("table", {"class": "dots"}, tag("thead", {}, tag("tr", {}, head)) + tag("tbody", {}, body))
    remarks = text_tag("p", {"class": "remarks"}, f"On none: {names_text(losers)}.") if losers else ""
    return tag("figure", {"class": "round"}, tag("figcaption", {}, caption) + tag("div", {"class": "scroll"}, table) + remarks)


def frontier_section(catalogue):
    content = "".join(map(round_html, rounds_of(catalogue)))
    return fill("section/frontier.html", content=content) if content else ""
