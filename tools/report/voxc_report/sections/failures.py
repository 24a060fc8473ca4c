"""Cells that failed, and why."""
from ..markup import fill, table_row, text_tag
from ..passes import pass_list
from ..text import count_text


def reason_text(failure):
    words = failure.get("words")
    reached = "" if words is None else f" (it reached {count_text(words)} words)"
    return (failure["reason"] or "no reason was recorded") + reached


def cells_of(entry):
    """A row without its devices: of what fails before it is traced there are as many as devices."""
    failure = entry.record["failure"]
    return "".join([text_tag("th", {"scope": "row"}, entry.look.name), text_tag("td", {}, entry.column),
                    text_tag("td", {}, pass_list(entry.passes)), text_tag("td", {}, failure["stage"]),
                    text_tag("td", {"class": "words"}, reason_text(failure))])


def failure_section(catalogue):
    rows = {}
    for entry in catalogue.entries:
        if not entry.is_measured:
            rows.setdefault(cells_of(entry), []).append(entry.device)
    html = "".join(table_row([cells, text_tag("td", {"class": "words"}, ", ".join(devices))]) for cells, devices in rows.items())
    return fill("section/failures.html", rows=html) if html else ""
