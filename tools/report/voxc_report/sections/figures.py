"""The table of every cell, which can be sorted, with a link to the same as comma-separated values."""
from urllib.parse import quote

from ..markup import escaped, fill, text_tag
from ..passes import pass_list
from ..text import count_text, number_text

MEBI = 1 << 20


def figure_text(value):
    return "" if value is None else number_text(value)


def in_mebi(value):
    return figure_text(None if value is None else value / MEBI)


def error_text(entry, kind):
    """A kind of errors, or "" if none was looked for."""
    return count_text(getattr(entry.errors, kind)) if entry.errors else ""


def of_record(section, name):
    return lambda entry: figure_text(entry.record[section].get(name))


def frontier_mark(entry):
    return "●" if entry.is_leading else "≈" if entry.is_as_good else ""


def outcome(entry):
    return "failed" if not entry.is_measured else "" if entry.is_steady else "not steady"


# The text of an entry in each column, and whether it is a number; numbers of one column share one unit, so that they can be sorted.
COLUMNS = {
    "Format": (False, lambda entry: entry.look.name),
    "Label": (False, lambda entry: entry.record["format"]["label"]),
    "Model": (False, lambda entry: entry.column),
    "Side": (True, lambda entry: str(entry.resolution)),
    "Device": (False, lambda entry: entry.device),
    "Steps": (False, lambda entry: entry.precision),
    "Passes": (False, lambda entry: pass_list(entry.passes)),
    "Size, MiB": (True, lambda entry: in_mebi(entry.size)),
    "Bytes a voxel": (True, of_record("volume", "bytes_per_voxel")),
    "Speed, Mrays/s": (True, lambda entry: figure_text(entry.speed and entry.speed.median)),
    "Of": (False, lambda entry: "GPU" if entry.has_clock else "CPU"),
    "Spread, %": (True, lambda entry: number_text(entry.speed.spread * 100) if entry.speed else ""),
    "Frontier": (False, frontier_mark),
    "Missed": (True, lambda entry: error_text(entry, "missed")),
    "Ghost": (True, lambda entry: error_text(entry, "ghost")),
    "Wrong": (True, lambda entry: error_text(entry, "wrong")),
    "Of rays": (True, lambda entry: error_text(entry, "rays")),
    "Lookups a ray": (True, of_record("work", "steps_per_ray")),
    "Words a ray": (True, of_record("work", "words_per_ray")),
    "Build, s": (True, of_record("build", "build_seconds")),
    "Build, CPU s": (True, of_record("build", "build_cpu_seconds")),
    "Peak, MiB": (True, lambda entry: in_mebi(entry.peak)),
    "Kernel, s": (True, of_record("kernel", "compile_seconds")),
    "First dispatch, s": (True, of_record("kernel", "first_dispatch_seconds")),
    "Outcome": (False, outcome),
}


def row_html(entry):
    """Without the end tags that HTML lets one leave out: the rows are the largest part of the page."""
    cells = [("<td class=n>" if is_number else "<td>") + escaped(text(entry)) for is_number, text in COLUMNS.values()]
    return f"<tr id={entry.row_id}>" + "".join(cells).replace("<td>", "<th scope=row>", 1) + "\n"


def figures_section(catalogue, csv_name):
    """The link is left out without the name of a file."""
    head = "".join(text_tag("th", {"scope": "col", "class": "n" if is_number else ""}, heading)
                   for heading, (is_number, _) in COLUMNS.items())
    link = csv_name and (" The same with all digits, for a spreadsheet: "
                         + text_tag("a", {"href": "./" + quote(csv_name, safe="-_.")}, csv_name) + ".")
    return fill("section/cells.html", head=head, rows="".join(map(row_html, catalogue.entries)), csv=link)
