"""The table below a chart: the formats on the frontier, and what makes them small or fast."""
from ..markup import escaped, table_row, tag, text_tag
from ..text import bytes_text, number_text, percent_text, plural

WORD_BYTES = 4
MANY_COLUMNS = 3

# What a ray costs: a heading, its meaning, and the figure of a record; a column is left out if no leader has a figure for it.
COLUMNS = [
    ("Lookups", "Lookups a ray, on the mean", lambda record: record["work"].get("steps_per_ray")),
    ("Words", "Words read a ray, on the mean", lambda record: record["work"].get("words_per_ray")),
    ("Lines", "Different cache lines a ray, as a search predicted", lambda record: record.get("predicted", {}).get("lines")),
    ("Predicted", "The speed that a search predicted", lambda record: record.get("predicted", {}).get("mrays_per_s")),
]


def level_bar(entry, most):
    """A bar as long as the size against the largest leader's, on the whole width, in a piece a level; and the same in words."""
    words = entry.record["volume"].get("level_words", [])
    if len(words) != len(entry.look.levels) or sum(words) == 0:
        return ""
    sizes = [WORD_BYTES * count for count in words]
    widths = [f"{100 * min(1, size / most):.1f}".removesuffix(".0") for size in sizes]
    pieces = "".join(tag("i", {"style": f"width:{width}%"}, "") for width in widths)
    text = " · ".join(f"{level} {bytes_text(size)}" for level, size in zip(entry.look.levels, sizes))
    return tag("div", {"class": "levels-bar", "aria-hidden": "true"}, pieces) + text_tag("small", {}, text)


def speed_cell(entry):
    rounds = entry.record["speed"].get("rounds")
    counted = "its rounds" if rounds is None else plural(rounds, "round")
    return tag("td", {"class": "n", "title": f"{number_text(entry.speed.min)} to {number_text(entry.speed.max)} in {counted}"},
               escaped(number_text(entry.speed.median)) + text_tag("small", {}, f"± {percent_text(entry.speed.spread / 2)}"))


def leader_row(leader, most, columns):
    figures = [value(leader.record) for _, _, value in columns]
    return table_row([
        tag("th", {"scope": "row"}, text_tag("span", {"class": "name"}, leader.name) + level_bar(leader, most)),
        text_tag("td", {"class": "n"}, bytes_text(leader.size)), speed_cell(leader),
        *(text_tag("td", {"class": "n"}, "" if figure is None else number_text(figure)) for figure in figures)])


def leader_table(stage):
    """The leaders of a stage from small to large, and why each stands where it does."""
    leaders = stage.leaders
    columns = [column for column in COLUMNS if any(column[2](leader.record) is not None for leader in leaders)]
    head = "".join([text_tag("th", {"scope": "col"}, "On the frontier"),
                    *(text_tag("th", {"scope": "col", "class": "n"}, name) for name in ("Size", "Speed")),
                    *(text_tag("th", {"scope": "col", "class": "n", "title": meaning}, name) for name, meaning, _ in columns)])
    body = "".join(leader_row(leader, leaders[-1].size, columns) for leader in leaders)
    style = "leaders many" if len(columns) >= MANY_COLUMNS else "leaders"
    return tag("div", {"class": "scroll"}, tag("table", {"class": style, "style": f"--figures:{len(columns) + 2}"},
                                               tag("thead", {}, tag("tr", {}, head)) + tag("tbody", {}, body)))
