"""Tables of bars: a row a format, a column a model; each cell has its figure in words and as a length."""
from dataclasses import dataclass, field

from ..markup import table_row, tag, text_tag


@dataclass
class Bar:
    value: float
    text: str
    note: str  # Shown when pointed at.
    tone: str = "plain"  # "better", "worse" or "equal": told by colour beside the length.


@dataclass
class BarTable:
    caption: str = ""
    reference: float = 0  # A value with a line across the bars; 0: none.
    bars: dict = field(default_factory=dict)  # By the names of row and column.

    @property
    def rows(self):
        return list(dict.fromkeys(row for row, _ in self.bars))

    @property
    def columns(self):
        return list(dict.fromkeys(column for _, column in self.bars))


def length(name, value, most):
    """A custom property that style.css makes a length of."""
    return f"--{name}:" + f"{100 * value / most:.1f}".removesuffix(".0") + "%"


def bar_html(bar, most, reference):
    if bar is None:
        return tag("td", {}, "")
    style = ";".join([length("length", bar.value, most)] + ([length("reference", reference, most)] if reference else []))
    name = f"bar {bar.tone}" + (" referred" if reference else "")
    line = text_tag("b", {}, bar.text) + tag("span", {"class": name, "style": style}, "")
    return tag("td", {"title": bar.note}, tag("div", {}, line))


def to_html(table):
    """All bars are drawn to one scale from 0."""
    columns = table.columns
    most = max([table.reference or 1e-300, *(bar.value for bar in table.bars.values())])
    head = "".join(text_tag("th", {"scope": "col"}, name) for name in ["Format", *columns])
    body = "".join(table_row([text_tag("th", {"scope": "row"}, row)] +
                             [bar_html(table.bars.get((row, column)), most, table.reference) for column in columns])
                   for row in table.rows)
    caption = text_tag("caption", {}, table.caption) if table.caption else ""
    return tag("div", {"class": "scroll"}, tag("table", {"class": "bars", "style": f"--columns:{len(columns)}"},
                                               caption + tag("thead", {}, tag("tr", {}, head)) + tag("tbody", {}, body)))
