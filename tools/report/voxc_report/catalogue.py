"""The catalogue: records with what all sections of the report need of them, and the stages on which formats compete."""
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple, Optional

from .devices import device_names
from .formats import Look, look_of
from .frontier import Place, Standing, standings
from .passes import pass_difference, common_passes
from .records import is_measured, rays_title
from .speeds import Speed, counts_own_time, speed_of


class Errors(NamedTuple):
    """Rays checked against the exact oracle, and those of them that differ."""
    rays: float
    missed: float
    ghost: float
    wrong: float

    @property
    def sum(self):
        return self.missed + self.ghost + self.wrong


@dataclass
class Entry:
    record: dict
    index: int  # In the order of the records.
    look: Look
    model: str  # Its name, with a number where several have it.
    device: str  # Short, and different for different devices.
    speed: Optional[Speed]
    size: Optional[float]  # Bytes of the volume; more than 0.
    peak: Optional[float]  # Bytes of building it.
    errors: Optional[Errors]
    column: str = ""  # The model, with the rays where it is traced by several.
    name: str = ""  # Of the format, and of the passes in which it differs from most: "G(8) +restart-sv".
    variant: int = 0  # The same for all entries of one format with the same passes.
    standing: Optional[Standing] = None  # In its stage; the rival is the index of an entry.

    @property
    def row_id(self):
        """The anchor of its row in the table of all figures."""
        return f"r{self.index + 1}"

    @property
    def passes(self):
        return self.record["format"]["passes"]

    @property
    def precision(self):
        return self.record["precision"]

    @property
    def resolution(self):
        return self.record.get("resolution", 0)

    @property
    def has_clock(self):
        return counts_own_time(self.record)

    @property
    def is_steady(self):
        return self.record["speed"].get("steady", True)

    @property
    def is_measured(self):
        return is_measured(self.record)

    @property
    def has_point(self):
        return self.size is not None and self.speed is not None

    @property
    def is_leading(self):
        return self.standing is not None and self.standing.place is Place.LEADING

    @property
    def is_as_good(self):
        return self.standing is not None and self.standing.place is Place.AS_GOOD

    @property
    def has_errors(self):
        return self.errors is not None and self.errors.sum > 0


@dataclass
class Stage:
    """One competition: formats, each with its passes, on the same model, rays, device, resolution and precision."""
    number: int  # In the order of the catalogue.
    entries: list
    common_passes: list  # Those of most cells of this resolution, which names do not say.

    def __post_init__(self):
        first = self.entries[0]
        self.model, self.column, self.device = first.model, first.column, first.device
        self.precision, self.resolution, self.has_clock = first.precision, first.resolution, first.has_clock
        self.points = [entry for entry in self.entries if entry.has_point]
        self.has_other_passes = any(entry.name != entry.look.name for entry in self.points)

    @cached_property
    def leaders(self):
        """From small and slow to large and fast, once the points are ranked."""
        return sorted((entry for entry in self.points if entry.is_leading), key=lambda entry: entry.size)


@dataclass
class Catalogue:
    entries: list = field(default_factory=list)  # In the order of the records.
    stages: list = field(default_factory=list)  # Models in their order; in each, large resolutions first.
    verdicts: list = field(default_factory=list)  # Of searches.

    def __post_init__(self):
        self.models = different(entry.model for entry in self.entries)
        self.columns = different(entry.column for entry in self.entries)
        self.devices = different(entry.device for entry in self.entries)

    @property
    def formats(self):
        """How many there are. A search counts a format with other passes as another one."""
        is_search = any(entry.record["made_by"]["command"].startswith("voxc search ") for entry in self.entries)
        return len({entry.look.name + (pass_difference(entry.passes, []) if is_search else "") for entry in self.entries})

    def verdict_on(self, stage):
        """The verdict of the search that a stage's cells are of, or None."""
        cells = {entry.record["cell"] for entry in stage.entries}
        return next((verdict for verdict in self.verdicts if not cells.isdisjoint(verdict.cells)), None)

    def rival_of(self, entry):
        return self.entries[entry.standing.rival]


def different(values):
    """The different values, in the order in which they first came."""
    return list(dict.fromkeys(values))


def positive(figure):
    return figure if figure is not None and figure > 0 else None


def errors_of(record):
    figures = [record["error"].get(name) for name in Errors._fields]
    return None if None in figures else Errors(*figures)


def model_names(records):
    """For each record what its model is called. Models that have one name and one resolution but differ, such as a file before
    and after a change, do not compete: the second is "hut (2)"."""
    known, names = {}, []
    for record in records:
        model = record["model"]
        digests = known.setdefault((model["name"], record.get("resolution", 0)), {})
        number = digests.setdefault(model["digest"], len(digests) + 1)
        names.append(model["name"] + (f" ({number})" if number > 1 else ""))
    return names


def make_entries(records):
    entries = [Entry(record, index, look_of(record["format"]["name"]), model, device, speed_of(record),
                     positive(record["volume"].get("bytes")), positive(record["build"].get("peak_rss_bytes")), errors_of(record))
               for index, (record, model, device) in enumerate(zip(records, model_names(records), device_names(records)))]
    name_columns(entries)
    name_entries(entries)
    return entries


def rays_names(entries):
    """For each entry what its rays are called. Those of one name that differ, such as a camera's at two sizes, do not compete."""
    known, names = {}, []
    for entry in entries:
        rays = entry.record["rays"]
        digests = known.setdefault((entry.model, entry.resolution, rays_title(rays)), {})
        number = digests.setdefault(rays["digest"], len(digests) + 1)
        names.append(rays_title(rays) + (f" ({number})" if number > 1 else ""))
    return names


def name_columns(entries):
    """A column is a model, with its rays where it has several."""
    rays, names = {}, rays_names(entries)
    for entry, name in zip(entries, names):
        if entry.record["rays"]["name"]:
            rays.setdefault(entry.model, set()).add(name)
    for entry, name in zip(entries, names):
        has_several = len(rays.get(entry.model, ())) > 1
        entry.column = f"{entry.model}, {name}" if has_several else entry.model


def common_passes_of(entries):
    """The most common passes of each resolution, so that a name is the same on all models and devices."""
    lists = {}
    for entry in entries:
        of_resolution = lists.setdefault(entry.resolution, [])
        if entry.is_measured:
            of_resolution.append(entry.passes)
    return {resolution: common_passes(passes) for resolution, passes in lists.items()}


def name_entries(entries):
    """Names that tell formats with their passes apart."""
    common, variants = common_passes_of(entries), {}
    for entry in entries:
        entry.name = entry.look.name + pass_difference(entry.passes, common[entry.resolution])
        entry.variant = variants.setdefault((entry.look.name, *sorted(entry.passes)), len(variants))


def make_stages(catalogue):
    common, groups = common_passes_of(catalogue.entries), {}
    for entry in catalogue.entries:
        key = (catalogue.models.index(entry.model), catalogue.columns.index(entry.column), -entry.resolution,
               catalogue.devices.index(entry.device), entry.precision, entry.has_clock)
        groups.setdefault(key, []).append(entry)
    return [Stage(number, groups[key], common[-key[2]]) for number, key in enumerate(sorted(groups))]


def rank_others(others, leaders):
    """Of a search, formats whose times are of other moments than those that are compared are beaten by the fastest leader that
    is no larger, or else by the smallest."""
    for entry in others:
        smaller = [leader for leader in leaders if leader.size <= entry.size]
        rival = smaller[-1] if smaller else leaders[0]
        entry.standing = Standing(Place.BEATEN, rival.index)


def rank(stage, verdict):
    """Sets the standings of a stage's points."""
    compared = stage.points
    if verdict and verdict.compared:
        compared = [entry for entry in stage.points if entry.record["cell"] in verdict.compared]
    for entry, found in zip(compared, standings([(entry.size, entry.speed) for entry in compared])):
        entry.standing = Standing(found.place, compared[found.rival].index)
    others = [entry for entry in stage.points if entry.standing is None]
    if stage.leaders:
        rank_others(others, stage.leaders)


def make_catalogue(records, verdicts=()):
    catalogue = Catalogue(make_entries(records), verdicts=list(verdicts))
    catalogue.stages = make_stages(catalogue)
    for stage in catalogue.stages:
        rank(stage, catalogue.verdict_on(stage))
    return catalogue
