"""The verdict in sentences: a line for each question, with the command that builds its answer."""
from ..build_command import build_command
from ..formats import look_of
from ..markup import escaped, tag, text_tag
from ..questions import questions_of
from ..speeds import counts_own_time, speed_unit
from ..text import bytes_text, count_text, number_text, plural
from ..words import list_names

MOST_RIVALS = 3


def legend_mark(family):
    """A family's mark by itself."""
    return tag("svg", {"class": f"key on f{family}", "viewBox": "-8 -8 16 16", "aria-hidden": "true"},
               tag("use", {"href": f"#m{family}"}, ""))


def rival_words(names):
    return f" As fast, within the spread: {list_names(names, MOST_RIVALS)}." if names else ""


def speed_on(answer, tells_precision):
    """"1.12 Mrays/CPU s on llvmpipe, exact", with a warning where the speed or the hits are not to be relied on."""
    entry = answer.entry
    text = f"{number_text(entry.speed.median)} {speed_unit(entry.has_clock)} on {entry.device}"
    if tells_precision and entry.precision:
        text += ", " + entry.precision
    if not entry.is_steady:
        text += " (not steady)"
    if entry.has_errors:
        text += f" ({count_text(entry.errors.sum)} of {count_text(entry.errors.rays)} rays wrong)"
    return text


def answer_html(answers, tells_precision, tells_command):
    """One format that answers, with what it does on each device that it answers for."""
    entry = answers[0].entry
    rivals = {}
    for rival in (rival for answer in answers for rival in answer.as_fast):
        rivals.setdefault(rival.variant, rival.name)
    speeds = "; ".join(speed_on(answer, tells_precision) for answer in answers)
    text = tag("p", {}, legend_mark(entry.look.family) + text_tag("b", {}, entry.name) + f", {bytes_text(entry.size)}: "
               + escaped(speeds) + "." + rival_words(list(rivals.values())))
    return text + (text_tag("code", {}, build_command(entry.record)) if tells_command else "")


def question_html(text, answers):
    return tag("div", {}, text_tag("dt", {}, text) + tag("dd", {}, answers)) + "\n"


def grouped(answers):
    """Answers by their format, in the order of the stages."""
    groups = {}
    for answer in answers:
        groups.setdefault(answer.entry.variant, []).append(answer)
    return groups


def verdict_html(stages):
    """The verdict on stages of one model at one resolution with the same rays."""
    tells_precision = len({stage.precision for stage in stages}) > 1
    told, rows = set(), ""
    for question in questions_of(stages):
        answers = ""
        for variant, group in grouped(question.answers).items():
            answers += answer_html(group, tells_precision, variant not in told)
            told.add(variant)
        rows += question_html(question.text, answers)
    return tag("dl", {"class": "verdict"}, rows) if rows else ""


def search_answer_html(place, answer, record, tells_command):
    text = (legend_mark(look_of(record["format"]["name"]).family) + text_tag("b", {}, place["name"])
            + escaped(f", {place['size']} at {place['speed']}"))
    if len(place["cells"]) > 1:
        text += escaped(f" ({place['set_speeds']})")
    text = tag("p", {}, text + "." + rival_words(answer["as_fast"]))
    return text + (text_tag("code", {}, build_command(record)) if tells_command else "")


def search_verdict_html(verdict, records):
    """What a search answers for all of its sets of rays together, in its own words. `records`: by their cells."""
    if not verdict.frontier:
        return ""
    told, rows = set(), ""
    for answer in verdict.answers:
        place = verdict.frontier[answer["format"]]
        record = records[place["cells"][0]]
        question = answer["question"][:1].upper() + answer["question"][1:]
        rows += question_html(question, search_answer_html(place, answer, record, answer["format"] not in told))
        told.add(answer["format"])
    record = records[verdict.frontier[0]["cells"][0]]
    clock = "device's own clock" if counts_own_time(record) else "processor's time"
    sentence = (f"Of {plural(verdict.formats, 'format')} that a search measured on {record['device']['name']}. M/s are million rays "
                f"a second of the {clock}, of the mean time of all sets of rays; the charts show each set by itself.")
    return tag("dl", {"class": "verdict"}, rows) + text_tag("p", {"class": "hint"}, sentence)
