"""The verdict: what each question of a reader has for an answer on one model."""
import math
from dataclasses import dataclass

from .catalogue import Entry, Stage
from .frontier import HARDLY_LARGER
from .speeds import are_equal
from .text import whole_bytes_text

MOST_BUDGETS = 3


@dataclass
class Answer:
    stage: Stage
    entry: Entry
    as_fast: list  # Others that answer as well, the fastest first: no speed tells them apart.


@dataclass
class Question:
    text: str  # "Smallest", "Fastest", "Best below 16 MiB".
    answers: list


def fastest_of(stage, budget):
    """The fastest leader within a budget, or else the smallest."""
    leaders = stage.leaders
    return [leader for leader in leaders if leader.size <= budget or leader is leaders[0]][-1]


def all_fastest_of(stages, budget):
    return [fastest_of(stage, budget).index for stage in stages]


def as_fast_as(answer, stage, budget):
    """Those within the budget that no speed tells from the answer."""
    others = [entry for entry in stage.points
              if entry is not answer and entry.size <= budget and are_equal(entry.speed, answer.speed)]
    return sorted(others, key=lambda entry: -entry.speed.median)


def budgets_of(stages):
    """Powers of two between the smallest and the largest leader whose answers differ from those before and from the fastest; of
    many those at the ends and in the middle."""
    least = min(stage.leaders[0].size for stage in stages)
    most = max(stage.leaders[-1].size for stage in stages)
    fastest, before, telling = all_fastest_of(stages, math.inf), all_fastest_of(stages, least), []
    while least < most:
        budget = 2.0 ** math.ceil(math.log2(least))
        answers = all_fastest_of(stages, budget)
        if answers not in (before, fastest):
            telling.append(budget)
        before, least = answers, least * 2
    if len(telling) > MOST_BUDGETS:
        telling = [telling[0], telling[len(telling) // 2], telling[-1]]
    return telling


def join_answers(answers):
    """Where a stage has for an answer what no measured difference tells from an answer already given, it gives that: so that
    chance does not make several answers of one."""
    for i, answer in enumerate(answers):
        given = {other.entry.variant for other in answers[:i]}
        most = answer.entry.size * (1 + HARDLY_LARGER)
        if answer.entry.variant in given:
            continue
        for place, other in enumerate(answer.as_fast):
            if other.variant in given and other.size <= most:
                answer.as_fast[place], answer.entry = answer.entry, other
                break


def ask(stages, text, budget, as_fast_within=None):
    """A question with its answers; what is as fast may be hardly larger, or as large as is said."""
    answers = []
    for stage in stages:
        entry = fastest_of(stage, budget)
        within = as_fast_within if as_fast_within is not None else entry.size * (1 + HARDLY_LARGER)
        answers.append(Answer(stage, entry, as_fast_as(entry, stage, within)))
    join_answers(answers)
    return Question(text, answers)


def questions_of(stages):
    """The questions that these stages, of one model at one resolution with the same rays, answer differently: the smallest, the
    fastest, and the fastest of at most 2^n bytes for up to three n. None without points."""
    stages = [stage for stage in stages if stage.leaders]
    if not stages:
        return []
    if all_fastest_of(stages, 0) == all_fastest_of(stages, math.inf):
        return [ask(stages, "Smallest and fastest", math.inf, math.inf)]
    between = [ask(stages, "Best below " + whole_bytes_text(budget), budget, budget) for budget in budgets_of(stages)]
    return [ask(stages, "Smallest", 0), *between, ask(stages, "Fastest", math.inf, math.inf)]
