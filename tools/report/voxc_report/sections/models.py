"""A section a model: the verdict, and size against speed on each device at each resolution."""
from collections import Counter

from ..catalogue import different
from ..charts.frontier import frontier_chart
from ..charts.scales import ranges_of
from ..formats import FAMILIES
from ..markup import escaped, fill, tag, text_tag
from ..text import count_text
from ..words import error_summary, list_names, resolution_title, stage_conditions, stage_title
from .leaders import leader_table
from .verdicts import legend_mark, search_verdict_html, verdict_html

# Longer lists are for the table.
MOST_NAMES = 6


def size_words(model):
    """"2048 × 857 × 1260 voxels, 12,345,678 of them not empty"; nothing if the size is not known."""
    if "size" not in model:
        return ""
    voxels = f", {count_text(model['voxels'])} of them not empty" if "voxels" in model else ""
    return " × ".join(map(str, model["size"])) + " voxels" + voxels


def facts(stages):
    """The sizes of a model, a line a resolution."""
    lines = different(size_words(entry.record["model"]) for stage in stages for entry in stage.entries)
    items = "".join(text_tag("li", {}, line) for line in lines if line)
    return tag("ul", {"class": "facts"}, items) if items else ""


def legend(stages):
    """The marks of the families that a model's charts show."""
    used = sorted({entry.look.family for stage in stages for entry in stage.points})
    items = "".join(tag("li", {}, legend_mark(family) + escaped(FAMILIES[family][0])) for family in used)
    return tag("ul", {"class": "legend", "aria-label": "Marks of the families of formats"}, items)


def remark(entries, what):
    """" Not steady: G(8), G(9) and 3 more."; nothing without entries."""
    return f" {what}: {list_names([entry.name for entry in entries], MOST_NAMES)}." if entries else ""


def remarks(stage):
    """What stands below a chart: what is as good, what was wrong, what failed."""
    return (remark([entry for entry in stage.points if entry.is_as_good], "As good as the frontier")
            + f" Errors: {escaped(error_summary(stage.entries))}."
            + remark([entry for entry in stage.points if not entry.is_steady], "Not steady")
            + remark([entry for entry in stage.entries if not entry.is_measured], "Failed"))


def stage_figure(stage, chart):
    """The chart of a stage, the table of its leaders, and what else is to be said of it; nothing if it has no points."""
    if not stage.points:
        return ""
    caption = text_tag("b", {}, stage_title(stage)) + " " + text_tag("span", {}, stage_conditions(stage))
    return tag("figure", {"class": "stage"}, tag("figcaption", {}, caption) + chart + leader_table(stage)
               + tag("p", {"class": "remarks"}, remarks(stage))) + "\n"


def verdicts(catalogue, stages, is_only):
    """The verdicts on stages of one resolution, one for each search and one for each other set of rays, with their names where
    there are several."""
    searches, by_rays = [], {}
    for stage in stages:
        if search := catalogue.verdict_on(stage):
            searches += [search] if search not in searches else []
        else:
            by_rays.setdefault(stage.column, []).append(stage)
    records = {entry.record["cell"]: entry.record for entry in catalogue.entries}
    text = "".join(search_verdict_html(search, records) for search in searches)
    for of_rays in by_rays.values():
        verdict = verdict_html(of_rays)
        needs_title = verdict and (not is_only or len(by_rays) + len(searches) > 1)
        text += (text_tag("h3", {}, resolution_title(of_rays[0])) if needs_title else "") + verdict
    return text


def groups_of(stages):
    """Stages of a model whose charts stand side by side: of one resolution."""
    groups = {}
    for stage in stages:
        groups.setdefault(stage.resolution, []).append(stage)
    return [groups[resolution] for resolution in sorted(groups, reverse=True)]


def draw_charts(catalogue):
    """The charts of the stages that have points, in the order of all stages; "" for others."""
    ranges = ranges_of(catalogue.stages)
    beside = Counter((stage.model, stage.resolution) for stage in catalogue.stages)
    return [frontier_chart(catalogue, stage, own, beside[stage.model, stage.resolution] == 1) if stage.points else ""
            for stage, own in zip(catalogue.stages, ranges)]


def figures(stages, charts):
    text = "".join(stage_figure(stage, charts[stage.number]) for stage in stages)
    return tag("div", {"class": "stages"}, "\n" + text) if text else ""


def model_section(catalogue, number, charts, pictures, notes):
    name = catalogue.models[number]
    stages = [stage for stage in catalogue.stages if stage.model == name]
    groups = groups_of(stages)
    content = "".join(figures(group, charts) for group in groups)
    if not content:
        return ""
    picture = {"class": "portrait", "src": pictures.get(name), "alt": f"A picture of {name}"}
    return fill("section/model.html", id=f"model-{number + 1}", name=escaped(name), facts=facts(stages), legend=legend(stages),
                verdict="".join(verdicts(catalogue, group, len(groups) == 1) for group in groups),
                picture=tag("img", picture, "") if name in pictures else "",
                note=text_tag("p", {"class": "note"}, notes[name]) if name in notes else "", figures=content)


def model_sections(catalogue, charts, pictures, notes):
    """`charts` are those of `draw_charts`; pictures, as addresses, and notes are those of models by their names."""
    return "".join(model_section(catalogue, number, charts, pictures, notes) for number in range(len(catalogue.models)))
