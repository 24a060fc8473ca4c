"""Verdicts that voxc search leaves beside its records: what the page says of a search is what the search printed."""
import json
import os
from dataclasses import dataclass

from .records import check_fields, is_count, is_text, list_of, names_in, optional, required
from .problems import Problem

ANSWER = {**required(question=is_text, format=is_count, as_fast=list_of(is_text))}
FORMAT = {**required(name=is_text, size=is_text, speed=is_text, set_speeds=is_text, cells=list_of(is_text))}


def is_object(value):
    return isinstance(value, dict)


VERDICT = {**required(formats=is_count, cells=list_of(is_text), compared=list_of(is_text), frontier=list_of(is_object),
                      answers=list_of(is_object)), **optional(is_text, "objective")}


@dataclass(frozen=True)
class SearchVerdict:
    formats: int  # That were tried, failures included; other passes make another format.
    cells: frozenset  # All of the search, by their digests.
    compared: frozenset  # Those whose times may be compared: only they are on a frontier.
    frontier: list  # From small and slow to large and fast: objects of FORMAT.
    answers: list  # From the smallest to the fastest, then balanced: objects of ANSWER.

    def answered(self, cell):
        """The questions that a cell's format answers."""
        return [answer["question"] for answer in self.answers if cell in self.frontier[answer["format"]]["cells"]]


def check_verdict(verdict, cells):
    """Holds a verdict to its fields, and to the cells that there are."""
    if not is_object(verdict):
        raise Problem("a verdict should be a JSON object")
    check_fields(verdict, VERDICT, "")
    for place in verdict["frontier"]:
        check_fields(place, FORMAT, "frontier.")
        if not place["cells"] or not cells.issuperset(place["cells"]):
            raise Problem("a format of the frontier has no record")
    for answer in verdict["answers"]:
        check_fields(answer, ANSWER, "answers.")
        if answer["format"] >= len(verdict["frontier"]):
            raise Problem("an answer is no format of the frontier")


def read_verdict(path, cells):
    with open(path, "rb") as file:
        verdict = json.loads(file.read())
    check_verdict(verdict, cells)
    return SearchVerdict(verdict["formats"], frozenset(verdict["cells"]), frozenset(verdict["compared"]), verdict["frontier"],
                         verdict["answers"])


def is_verdict_file(name):
    return name.startswith("verdict-") and name.endswith(".json")


def read_verdicts(folders, records):
    """The verdicts of all folders, and a note on each that is none of these records."""
    cells = {record["cell"] for record in records}
    verdicts, notes = [], []
    for folder in folders:
        for name in names_in(folder, is_verdict_file):
            path = os.path.join(folder, name)
            try:
                verdicts.append(read_verdict(path, cells))
            except (OSError, ValueError, RecursionError, Problem) as problem:
                notes.append(f"the verdict '{path}' is left out: {problem}")
    return verdicts, notes
