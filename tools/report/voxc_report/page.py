"""Putting the sections into the page."""
from .markup import fill, read_page, tag, text_tag
from .pictures import thumbnail
from .problems import Problem
from .sections.effects import dedup_section, precision_section, restart_section, unroll_section
from .sections.failures import failure_section
from .sections.figures import figures_section
from .sections.frontiers import frontier_section
from .sections.memory import memory_section
from .sections.method import introduction_section, method_section
from .sections.models import draw_charts, model_sections
from .sections.predictions import prediction_section

# What the page should not exceed, and what one picture may take of it at most, and at least if there are few.
PAGE_BYTES = 980_000
MOST_OF_ONE, LEAST_OF_ONE = 90_000, 12_000

# The sections: where a link leads, what the list of contents says, and what makes it. Empty ones are left out.
SECTIONS = [
    ("frontier", "Frontiers", frontier_section),
    ("predictions", "Predictions", prediction_section),
    ("dedup", "Sharing", dedup_section),
    ("restart", "Restarting", restart_section),
    ("unroll", "Unrolling", unroll_section),
    ("precision", "Exactness", precision_section),
    ("memory", "Memory", memory_section),
    ("failures", "Failures", failure_section),
]


def load_pictures(entries, room):
    """The first picture of each model as an address, all within so many bytes; and notes on those that are left out."""
    paths, pictures, notes = {}, {}, []
    for entry in entries:
        if "picture" in entry.record["model"]:
            paths.setdefault(entry.model, entry.record["model"]["picture"])
    for model, path in sorted(paths.items()):
        try:
            pictures[model] = thumbnail(path, min(max(room // len(paths), LEAST_OF_ONE), MOST_OF_ONE))
        except Problem as problem:
            notes.append(str(problem))
    return pictures, notes


def bytes_of(text):
    return len(text.encode("utf-8", "replace"))


def make_page(catalogue, model_notes, csv_name):
    """The page as text, and notes on what could not be shown. `model_notes`: a sentence on models by their names; `csv_name`: what
    the link to the comma-separated values says, "" for none."""
    rest = [(name, title, make(catalogue)) for name, title, make in SECTIONS]
    rest += [("cells", "All figures", figures_section(catalogue, csv_name)), ("method", "Method", method_section(catalogue))]
    charts = draw_charts(catalogue)

    def page_with(pictures):
        return assemble(catalogue, [("models", "Models", model_sections(catalogue, charts, pictures, model_notes)), *rest])

    room = max(0, PAGE_BYTES - bytes_of(page_with({})))
    pictures, notes = load_pictures(catalogue.entries, room)
    return page_with(pictures), notes


def assemble(catalogue, sections):
    sections = [section for section in sections if section[2]]
    contents = "".join(tag("li", {}, text_tag("a", {"href": f"#{name}"}, title)) for name, title, _ in sections)
    body = "".join(tag("div", {"id": name}, html) for name, _, html in sections)
    return fill("page.html", style=read_page("style.css"), script=read_page("report.js"), contents=contents, sections=body,
                introduction=introduction_section(catalogue))
