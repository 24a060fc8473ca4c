"""The largest memory of building, by format and model."""
from ..markup import fill, tag, text_tag
from ..text import bytes_text, plural
from ..words import side_text, whole_name
from .bars import Bar, BarTable, to_html

STANDS_OUT = 1.5  # Times the next.
ABOUT_THE_SAME = 1.25
MOST_ROWS, LARGEST_ROWS = 40, 15


def peak_tables(catalogue):
    """A table a resolution, large ones first."""
    tables = {}
    for entry in catalogue.entries:
        if entry.peak is None:
            continue
        bars = tables.setdefault(entry.resolution, BarTable(side_text(entry.resolution))).bars
        place = entry.look.name, entry.model
        if place not in bars or entry.peak >= bars[place].value:
            bars[place] = Bar(entry.peak, bytes_text(entry.peak), whole_name(entry))
    return [tables[resolution] for resolution in sorted(tables, reverse=True)]


def mark_largest(table):
    """Marks the largest of each column, if it stands out."""
    for column in table.columns:
        bars = sorted((bar for (_, other), bar in table.bars.items() if other == column), key=lambda bar: bar.value)
        if len(bars) > 1 and bars[-1].value >= STANDS_OUT * bars[-2].value:
            bars[-1].tone = "worse"


def largest_rows(table):
    """The rows that need most, where there are too many to be looked at."""
    rows = table.rows
    if len(rows) <= MOST_ROWS:
        return table
    most = {row: max(bar.value for (other, _), bar in table.bars.items() if other == row) for row in rows}
    kept = sorted(rows, key=lambda row: (most[row], rows.index(row)), reverse=True)[:LARGEST_ROWS]
    caption = f"{table.caption}, the {LARGEST_ROWS} of {len(rows)} formats that need most"
    bars = {(row, column): table.bars[row, column] for row in kept for column in table.columns if (row, column) in table.bars}
    return BarTable(caption, table.reference, bars)


def table_html(table):
    """A sentence where all need about the same, for equal bars say nothing; else the bars."""
    values = [bar.value for bar in table.bars.values()]
    if max(values) <= ABOUT_THE_SAME * min(values):
        return tag("p", {}, text_tag("b", {}, table.caption) + f": all of {plural(len(table.rows), 'format')} need about the same, "
                   f"{bytes_text(min(values))} to {bytes_text(max(values))}.")
    mark_largest(table)
    return to_html(largest_rows(table))


def memory_section(catalogue):
    content = "".join(map(table_html, peak_tables(catalogue)))
    return fill("section/memory.html", content=content) if content else ""
