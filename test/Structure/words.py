#!/usr/bin/env python3
"""Holds the words of the tree to lists: words.py TREE LIST

LIST has tables, each below a line "NAME:" that names what is read for it, as PLACES below has it:

    REGEX | what is right | why

A line "Not yet: FILE ..." leaves files out. Of docs/glossary.md each word has one meaning, stands in its order, and is used by another
page; each word of its second table, which says what others call it, stands in the first. Everything else in LIST is prose.
"""
import re
import sys
from pathlib import Path

ROW = re.compile(r"^(\S.*?) +\| (.+?) \| (.+)$")
HEADING = re.compile(r"^(\w[\w ]*):$")
# Paths and addresses, whose words are those of files.
PATH = re.compile(r"[\w./-]*\w\.(?:md|jsonl?|vox|py|txt|csv|svg|jpg)\b(?:#\d+)?|https?://\S+")
COMMENT = re.compile(r"//.*|/\*.*?\*/", re.DOTALL)

PLACES = {
    "Prose": ("docs/*.md", "*.md", "test/Driver/Inputs/help-*.txt", "include/**/*.h"),
    "Names": ("include/**/*.h", "lib/**/*.h", "lib/**/*.cpp", "tools/**/*.h", "tools/**/*.cpp", "apps/**/*.h", "apps/**/*.cpp",
              "shaders-runtime/**/*.glsl", "cpu-runtime/*", "construct-runtime/**/*.cpp", "python/**/*.py"),
}
HISTORY = {"CHANGELOG.md"}


def read_list(path):
    tables, current, left_out = {name: [] for name in PLACES}, None, set(HISTORY)
    for line in path.read_text().split("\n"):
        heading, row = HEADING.match(line), ROW.match(line)
        if line.startswith("Not yet:"):
            left_out.update(line.split(":", 1)[1].split())
        elif heading:
            current = tables.get(heading[1])
        elif row and current is not None:
            current.append((re.compile(row[1]), row[2]))
    return tables, left_out


def prose_of(path):
    """Of headers the comments alone, with lines kept where they are."""
    text = path.read_text()
    if path.suffix == ".h":
        text = blanked(text, COMMENT)
    return PATH.sub("", text)


def blanked(text, kept):
    """The text with nothing but newlines outside of what is kept."""
    parts, end = [], 0
    for match in kept.finditer(text):
        parts += [re.sub(r"[^\n]+", "", text[end:match.start()]), match[0]]
        end = match.end()
    return "".join(parts)


def banned(tree, tables, left_out):
    for name, rows in tables.items():
        for path in sorted({path for pattern in PLACES[name] for path in tree.glob(pattern)}):
            where = path.relative_to(tree).as_posix()
            if where in left_out or not path.is_file():
                continue
            text = prose_of(path) if name == "Prose" else PATH.sub("", path.read_text())
            for number, line in enumerate(text.split("\n"), 1):
                for word, right in rows:
                    if found := word.search(line):
                        yield f"{where}:{number}: '{found[0]}' is not a word of this tree; {right}"


def tables_of(page):
    """The rows of each table of a page, without its head."""
    tables, rows = [], []
    for line in page.split("\n") + [""]:
        if line.startswith("|"):
            rows.append([cell.strip() for cell in line.strip("|").split("|")])
        elif rows:
            tables.append(rows[2:])
            rows = []
    return tables


def is_used(term, pages):
    forms = re.escape(term)
    if term.endswith("y"):
        forms = f"(?:{forms}|{re.escape(term[:-1])}ies)"
    return re.search(rf"\b{forms}(?:s|es|ed|ing)?\b", pages, re.IGNORECASE)


def glossary(tree, left_out):
    page = tree / "docs/glossary.md"
    terms, others = tables_of(page.read_text())
    pages = "\n".join(path.read_text() for path in tree.glob("docs/*.md") if path != page)
    names = [term for term, _ in terms]
    if names != sorted(names, key=str.lower):
        yield "docs/glossary.md: its words should be in the order of the alphabet"
    for term, meaning in terms:
        if names.count(term) > 1 or re.search(r"[;,] also\b|\bor also\b|\b1\. ", meaning):
            yield f"docs/glossary.md: '{term}' should have one meaning; what has another needs a word of its own"
        if not is_used(term, pages):
            yield f"docs/glossary.md: no page uses '{term}'"
    for term, _ in others:
        if term not in names:
            yield f"docs/glossary.md: '{term}' is called otherwise elsewhere, but is not explained above"


def main(tree, path):
    tables, left_out = read_list(path)
    wrong = [*banned(tree, tables, left_out), *glossary(tree, left_out)]
    empty = [name for name, rows in tables.items() if not rows]
    sys.exit("\n".join(wrong + [f"the list has no rows below '{name}:'" for name in empty]) or None)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
