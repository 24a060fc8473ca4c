"""What one thing changes, all else being the same: whole-level-dedup, restart-sv, unroll-sv, exact steps."""
from ..markup import escaped, fill
from ..pairs import pairs_by_pass, pairs_by_precision
from ..text import bytes_text, number_text, plural
from ..words import error_words, speed_words
from .bars import Bar, BarTable, to_html


def times_text(ratio):
    return number_text(ratio) + "×"


def fill_section(path, tables):
    content = "".join(map(to_html, tables))
    if not content:
        return ""
    found = [(bar.value, f"{row} of {column}") for table in tables for (row, column), bar in table.bars.items()]
    most, least = max(found, key=lambda one: one[0]), min(found, key=lambda one: one[0])
    return fill(path, content=content, most=times_text(most[0]), most_name=escaped(most[1]), least=times_text(least[0]),
                least_name=escaped(least[1]))


def speed_note(pair, with_it, without):
    return "\n".join(f"{name}: {speed_words(entry)}; {error_words(entry)}"
                     for name, entry in ((with_it, pair.with_it), (without, pair.without)))


def error_mark(pair):
    """The rays that either of the two got wrong, where there are any."""
    count = sum(entry.errors.sum for entry in pair if entry.errors)
    return ", " + plural(count, "error") if count > 0 else ""


def tone_of(pair):
    return "equal" if pair.is_as_fast else "better" if pair.speed_up > 1 else "worse"


def speed_tables(pairs, with_it, without):
    """Speeds of pairs, a table a device."""
    tables = {}
    for pair in pairs:
        if pair.speed_up is None:
            continue
        table = tables.setdefault(pair.with_it.device, BarTable("On " + pair.with_it.device, 1))
        words = times_text(pair.speed_up) + (" =" if pair.is_as_fast else "") + error_mark(pair)
        table.bars.setdefault((pair.with_it.look.name, pair.with_it.column),
                              Bar(pair.speed_up, words, speed_note(pair, with_it, without), tone_of(pair)))
    return list(tables.values())


def dedup_section(catalogue):
    """How much smaller whole-level-dedup makes volumes."""
    table = BarTable(reference=1)
    for pair in pairs_by_pass(catalogue, "whole-level-dedup"):
        if pair.shrinkage is not None:
            note = f"{bytes_text(pair.without.size)} without, {bytes_text(pair.with_it.size)} with"
            tone = "better" if pair.shrinkage > 1 else "equal"
            table.bars.setdefault((pair.with_it.look.name, pair.with_it.model),
                                  Bar(pair.shrinkage, times_text(pair.shrinkage), note, tone))
    return fill_section("section/dedup.html", [table] if table.bars else [])


def restart_section(catalogue):
    """How much faster restart-sv makes kernels."""
    return fill_section("section/restart.html", speed_tables(pairs_by_pass(catalogue, "restart-sv"), "restart", "stack"))


def unroll_section(catalogue):
    """How much faster unroll-sv makes kernels."""
    return fill_section("section/unroll.html", speed_tables(pairs_by_pass(catalogue, "unroll-sv"), "unrolled", "stack"))


def precision_section(catalogue):
    """What exact steps cost, and what float steps get wrong."""
    return fill_section("section/precision.html", speed_tables(pairs_by_precision(catalogue), "fast", "exact"))
