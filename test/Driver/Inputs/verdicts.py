"""verdicts.py TERMINAL JSON FOLDER: what terminal, JSON, page and CSV say of one search, compared."""
import csv
import html
import json
import os
import re
import sys

terminal, figures, folder = open(sys.argv[1]).read(), json.load(open(sys.argv[2])), sys.argv[3]
page = open(os.path.join(folder, "report.html"), encoding="utf-8").read()
rows = list(csv.DictReader(open(os.path.join(folder, "report.csv"), encoding="utf-8", newline="")))

answer = r"(.+), ([0-9.]+ [KM]iB) at ([0-9.]+) M/s"


def of_terminal():
    answers = dict((q, a) for q, *a in re.findall(r"^([a-z][a-zA-Z0-9. ]+): +" + answer + "$", terminal, re.M))
    return int(re.match(r"(\d+) of \d+ formats measured", terminal)[1]), answers


def of_page():
    listed = re.search(r'<dl class="verdict">(.*?)</dl><p class="hint">(.*?)</p>', page, re.S)
    answers = {}
    for question, words in re.findall(r"<dt>(.*?)</dt><dd><p>(.*?)</p>", listed[1], re.S):
        plain = html.unescape(re.sub("<[^>]*>", "", words))
        answers[question[0].lower() + question[1:]] = list(re.match(answer, plain).groups())
    assert re.search(r"measurements? of ([\d,]+) formats?", page)[1] == re.search(r"Of ([\d,]+) formats?", listed[2])[1]
    return int(re.search(r"Of ([\d,]+) formats?", listed[2])[1]), answers


def size(count):
    return "%.1f KiB" % (count / 1024) if count < 1 << 20 else "%.2f MiB" % (count / (1 << 20))


def of_json():
    verdict = figures["verdict"]
    answers = {q: [a["name"], size(a["bytes"]), "%.2f" % a["mrays_per_s"]] for q, a in verdict.items() if isinstance(a, dict)}
    assert figures["measured"] == verdict["formats"]
    return verdict["formats"], answers


def of_csv(names):
    """A row has no plain name: that of the other outputs is taken, if the format begins it; the speed is that of the mean time."""
    found = {}
    for row in rows:
        for question in filter(None, row["verdict"].split("; ")):
            found.setdefault(question, []).append(row)
    answers = {}
    for question, of in found.items():
        assert len({(r["format"], r["passes"]) for r in of}) == 1, question
        name = names[question][0] if names[question][0].split(" with ")[0] == of[0]["format"] else of[0]["format"]
        speed = len(of) / sum(1 / float(r["mrays_per_s"]) for r in of)
        answers[question] = [name, size(int(of[0]["bytes"])), "%.2f" % speed]
    return len({(row["format"], row["passes"]) for row in rows}), answers


told = of_terminal()
assert {"smallest", "fastest", "balanced"} <= set(told[1]), told
for name, other in ("page", of_page()), ("JSON", of_json()), ("CSV", of_csv(told[1])):
    print(f"{name}: the same" if other == told else f"{name}: {other}, but the terminal: {told}")

# What the command at the end builds is one of the formats above it.
command, meaning = [line for line in terminal.splitlines() if line][-1], [line for line in terminal.splitlines() if line][-2]
question = re.match("balanced|smallest|fastest", meaning)[0]
print("the command is that of", question if command.startswith("voxc build '" + told[1][question][0].split(" with ")[0] + "'") else command)
