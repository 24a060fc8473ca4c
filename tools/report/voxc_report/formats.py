"""How formats look: one spelling for each, and the families that marks tell apart."""
import re
from dataclasses import dataclass, field

# Of each kind: whether it is a tree, its parameters, and what a parameter is that need not be written. docs/formats.md.
TREE, GRID = True, False
KINDS = {
    "R": (GRID, ("width", "height", "depth"), {}),
    "D": (GRID, ("width", "height", "depth", "reach"), {}),
    "H": (GRID, ("width", "height", "depth"), {}),
    "M": (GRID, ("width", "height", "depth"), {}),
    "S": (TREE, ("side",), {}),
    "G": (TREE, ("side", "branching"), {"branching": 1}),
}
LEVEL = re.compile(r"\s*([A-Z])\s*\(([^()]*)\)\s*")
CUBE = re.compile(r"\s*(\d+)\s*\^\s*3\s*")
NUMBER = re.compile(r"\s*\d+\s*")


@dataclass(frozen=True)
class Level:
    kind: str
    parameters: dict

    @property
    def is_tree(self):
        return KINDS[self.kind][0]

    @property
    def text(self):
        """"R(4³)", "D(4³, 6)", "R(4, 4, 5)", "G(7)"."""
        _, names, defaults = KINDS[self.kind]
        sizes = [self.parameters[name] for name in names[:3]]
        words = []
        if not self.is_tree and sizes == 3 * sizes[:1]:
            words, names = [f"{sizes[0]}³"], names[3:]
        words += [str(self.parameters[name]) for name in names if self.parameters[name] != defaults.get(name)]
        return f"{self.kind}({', '.join(words)})"


def parse_arguments(text):
    """"4^3, 6" is 4, 4, 4, 6; None if it is no list of numbers."""
    numbers = []
    for word in text.split(","):
        if cube := CUBE.fullmatch(word):
            numbers += 3 * [int(cube[1])]
        elif NUMBER.fullmatch(word):
            numbers.append(int(word))
        else:
            return None
    return numbers


def parse_level(letter, text):
    """A level, or None."""
    numbers = parse_arguments(text)
    if letter not in KINDS or numbers is None:
        return None
    _, names, defaults = KINDS[letter]
    if len(numbers) > len(names) or any(name not in defaults for name in names[len(numbers):]):
        return None
    return Level(letter, {**defaults, **dict(zip(names, numbers))})


def parse(text):
    """The levels of a format string, or [] if it is none."""
    levels, place = [], 0
    while place < len(text):
        match = LEVEL.match(text, place)
        level = match and parse_level(match[1], match[2])
        if not level:
            return []
        levels.append(level)
        place = match.end()
    return levels


def is_grid_over_tree(levels):
    return not levels[0].is_tree and levels[-1].is_tree


# A format belongs to the first family whose condition holds.
FAMILIES = [
    ("D over a tree", lambda levels: is_grid_over_tree(levels) and any(level.kind == "D" for level in levels)),
    ("R over a DAG (G)", lambda levels: is_grid_over_tree(levels) and levels[-1].kind == "G"),
    ("R over an octree (S)", is_grid_over_tree),
    ("trees alone", lambda levels: all(level.is_tree for level in levels)),
    ("grids alone", lambda levels: not any(level.is_tree for level in levels)),
    ("others", lambda levels: True),
]


@dataclass(frozen=True)
class Look:
    name: str  # "R(4³) G(7)".
    family: int  # Of FAMILIES.
    levels: list = field(default_factory=list)  # The name in parts; none if it cannot be read.


def look_of(text):
    """The look of a format string; one that cannot be read keeps its text and belongs to the last family."""
    levels = parse(text)
    if not levels:
        return Look(text, len(FAMILIES) - 1)
    family = next(i for i, (_, holds) in enumerate(FAMILIES) if holds(levels))
    names = [level.text for level in levels]
    return Look(" ".join(names), family, names)
