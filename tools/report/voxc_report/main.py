"""The program: `voxc bench report` with its arguments.

What was noted is a line each of standard error; why it failed is the last line, and the exit code tells of what kind that is
(problems). voxc says both in its words.
"""
import argparse
import os
import signal
import sys

from .catalogue import make_catalogue, model_names
from .csv_table import to_csv
from .output import is_file, write
from .page import bytes_of, make_page
from .problems import Problem, UsageProblem
from .records import read_folders
from .searches import read_verdicts

LARGE_PAGE = 1_000_000
MOST_NOTES = 10


def parse_arguments(words):
    parser = argparse.ArgumentParser(prog="voxc bench report", description="One HTML file of the records of voxc bench")
    parser.add_argument("folders", metavar="DIR", nargs="+", help="folders of records")
    parser.add_argument("-o", "--output", metavar="FILE", help="the page, with its figures as CSV beside it; - for standard output")
    parser.add_argument("--note", metavar="MODEL=TEXT", action="append", default=[], help="a sentence on a model")
    return parser.parse_args(words)


def model_notes(arguments, records):
    models = set(model_names(records))
    notes = {}
    for argument in arguments:
        name, equals, text = argument.partition("=")
        if not equals:
            raise UsageProblem(f"--note '{argument}' has no '='; it should be MODEL=TEXT")
        if name not in models:
            raise UsageProblem(f"--note is on '{name}', but no record is of a model of that name")
        notes[name] = text
    return notes


def csv_path(page):
    """Where the figures go: no place if the page goes to standard output or a device."""
    if page == "-" or not is_file(page):
        return ""
    path = os.path.splitext(page)[0] + ".csv"
    if path == page:
        raise UsageProblem(f"-o '{page}' should be the page, such as report.html; the figures go into a .csv beside it")
    return path


def check_no_records(page, folders):
    """Refuses to write over records, of which all .jsonl files of a folder are."""
    whole = os.path.realpath(page)
    if whole.endswith(".jsonl") and os.path.dirname(whole) in map(os.path.realpath, folders):
        raise UsageProblem(f"-o '{page}' would be one of the records; name the page, such as report.html")


def tell(notes):
    for note in notes[:MOST_NOTES]:
        print(note, file=sys.stderr)
    if len(notes) > MOST_NOTES:
        print(f"and {len(notes) - MOST_NOTES} more of the kind", file=sys.stderr)


def make_report(arguments):
    records = read_folders(arguments.folders)
    about_models = model_notes(arguments.note, records)
    page = arguments.output or os.path.join(arguments.folders[0], "report.html")
    csv = csv_path(page)
    check_no_records(page, arguments.folders)
    verdicts, notes = read_verdicts(arguments.folders, records)
    catalogue = make_catalogue(records, verdicts)
    html, more_notes = make_page(catalogue, about_models, os.path.basename(csv))
    notes += more_notes
    if bytes_of(html) > LARGE_PAGE:
        notes.append(f"the report has {bytes_of(html)} bytes; fewer folders would make a page that opens faster")
    if csv:
        write(csv, to_csv(catalogue))
    write(page, html)
    tell(notes + ([f"wrote {page} and {csv}"] if csv else []))


def stop(*_):
    raise KeyboardInterrupt


def main(words=None):
    signal.signal(signal.SIGTERM, stop)  # So that nothing unfinished is left behind.
    try:
        make_report(parse_arguments(words))
    except Problem as problem:
        print(problem, file=sys.stderr)
        return problem.exit_code
    except KeyboardInterrupt:
        return 130
    return 0
