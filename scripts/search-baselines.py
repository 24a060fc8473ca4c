#!/usr/bin/env python3
"""How many measurements a search of formats takes, beside random choice and beside evolution.

  search-baselines.py ALL FOUND    folders of voxc search: ALL of every format (--formats list --all), FOUND of a search;
                                   or ALL is a table of such records, as docs/evaluation/exhaustive-sponza-512.csv
  search-baselines.py BENCH        a folder of voxc bench, in which the frontier of a search was measured in turn with a list

The formats of ALL are the world: to measure one is to look into its records, for random choice, for evolution and for
the formats of FOUND, in the order in which that search took them. A format that ALL does not have counts with what FOUND
measured, times the median ratio of the formats that both have.
In BENCH, formats with labels are those of the list, and those without the search's; both may have been measured with
several lists of passes.
Evolution is NSGA-II (Deb et al. 2002) as DEAP has it (Debian: python3-deap). The area below the frontier is that of
voxc search: log2 of bytes times million rays a second, up to 64 times the smallest; shares are of what all
measurements of both folders reach together.
"""
import csv
import json
import math
import random
import re
import statistics
import sys
from pathlib import Path

from deap import base, creator, tools

KINDS = "RDSGMH"
MOST = 64  # Times the smallest size.
COUNTS = (8, 12, 20, 40, 80, 160, 320, 640)
RUNS = 100
POPULATION = 20
GENERATIONS = 150


def read(folder, of_list=None):
    """The formats of a folder in the order in which they were measured: (name, passes) -> (bytes, rays/s); of those with
    labels, or without, alone if `of_list` says which."""
    times = {}
    for line in (Path(folder) / "results.jsonl").read_text().splitlines():
        record = json.loads(line)
        if record["status"] != "measured" or of_list not in (None, bool(record["format"]["label"])):
            continue
        if sum(record["error"][kind] for kind in ("missed", "ghost", "wrong")):
            sys.exit(f"{record['format']['name']} has wrong rays")
        key = (record["format"]["name"], *record["format"]["passes"])
        sets = times.setdefault(key, (record["volume"]["bytes"], {}))[1]
        sets[record["rays"]["digest"]] = 1 / record["speed"]["mrays_per_cpu_s"]["median"]
    return {key: (size, len(sets) / sum(sets.values())) for key, (size, sets) in times.items()}


def read_table(path):
    """The same of a table of records."""
    with open(path, newline="") as file:
        return {(row["format"], *row["passes"].split()):
                (4 * int(row["words"]), 2 / sum(1 / float(row["mrays_" + rays]) for rays in ("overview", "bounced")))
                for row in csv.DictReader(file)}


def in_world(found, everything):
    """What the formats of a search are in the world's records."""
    def known(key):
        return (parse(key[0]), *key[1:])
    world = {known(key): value for key, value in everything.items()}
    ratio = statistics.median(world[known(key)][1] / rate for key, (_, rate) in found.items() if known(key) in world)
    return [world.get(known(key), (size, rate * ratio)) for key, (size, rate) in found.items()]


def area(points, most):
    """Below the best speed at each size, in octaves of bytes times million rays a second."""
    total, speed, last = 0.0, 0.0, None
    for size, rate in sorted(points):
        if size >= most or rate <= speed:
            continue
        if last is not None:
            total += speed * (math.log2(size) - last)
        speed, last = rate, math.log2(size)
    return total + (speed * (math.log2(most) - last) if last is not None else 0.0)


def parse(name):
    """A format as levels: (kind, log2 of its cells)."""
    return tuple((kind, int(cells)) for kind, cells in re.findall(r"([A-Z])\((\d+)", name))


def rewrite(levels):
    """One change that keeps the whole: another kind, a height moved, a level split or two merged."""
    levels = [list(level) for level in levels]
    at = random.randrange(len(levels))
    act = random.choice(("kind", "move", "split", "merge"))
    if act == "kind":
        levels[at][0] = random.choice(KINDS)
    elif act == "move" and at > 0:
        step = random.choice((-1, 1))
        levels[at - 1][1] += step
        levels[at][1] -= step
    elif act == "split" and levels[at][1] > 1:
        upper = random.randrange(1, levels[at][1])
        levels[at:at + 1] = [[levels[at][0], upper], [random.choice(KINDS), levels[at][1] - upper]]
    elif act == "merge" and at > 0:
        levels[at - 1:at + 1] = [[levels[at - 1][0], levels[at - 1][1] + levels[at][1]]]
    return tuple(tuple(level) for level in levels)


def cross(one, other):
    """The upper levels of one and the lower ones of the other, where both end a level at the same height."""
    def heights(levels):
        return {sum(cells for _, cells in levels[:i]): i for i in range(1, len(levels))}
    shared = [(i, heights(other)[at]) for at, i in heights(one).items() if at in heights(other)]
    if not shared:
        return one
    upper, lower = random.choice(shared)
    return one[:upper] + other[lower:]


def evolve(world, measured):
    """NSGA-II; formats are added to `measured` in the order in which it asks for them, each once."""
    def rated(levels):
        individual = creator.Individual(levels)
        size, rate = world[levels]
        individual.fitness.values = (math.log2(size), rate)
        if levels not in measured:
            measured.append(levels)
        return individual

    parents = [rated(levels) for levels in random.sample(list(world), POPULATION)]
    parents = tools.selNSGA2(parents, POPULATION)
    for _ in range(GENERATIONS):
        if len(measured) >= min(COUNTS[-1], len(world)):
            return
        children = []
        while len(children) < POPULATION:
            one, other = tools.selTournamentDCD(parents, 4)[:2]
            child = cross(tuple(one), tuple(other)) if random.random() < 0.5 else tuple(one)
            child = rewrite(child)
            if child in world:
                children.append(rated(child))
        parents = tools.selNSGA2(parents + children, POPULATION)


def mean_shares(runs, world, most, whole):
    rows = {count: [] for count in COUNTS}
    for measured in runs:
        for count in COUNTS:
            if len(measured) >= count:
                rows[count].append(area([world[levels] for levels in measured[:count]], most) / whole)
    return {count: statistics.mean(shares) for count, shares in rows.items() if shares}


def beside_list(folder):
    """The area below the frontier of a list of formats, as a share of that of a search's formats."""
    listed, found = read(folder, of_list=True), read(folder, of_list=False)
    most = MOST * min(size for size, _ in (*listed.values(), *found.values()))
    whole = area(found.values(), most)
    smallest, fastest = min(size for size, _ in found.values()), max(rate for _, rate in found.values())
    print("| Formats | Measured | Area, of the search's | Smallest, times | Fastest, times |\n|---|---:|---:|---:|---:|")
    groups = {" ".join(passes): [] for _, *passes in listed}
    for (_, *passes), value in listed.items():
        groups[" ".join(passes)].append(value)
    for name, values in (*groups.items(), ("with any of these", list(listed.values())), ("of the search", list(found.values()))):
        size, rate = min(size for size, _ in values), max(rate for _, rate in values)
        print(f"| {name} | {len(values)} | {area(values, most) / whole:.1%} | {size / smallest:.2f} | {rate / fastest:.2f} |")
    best, value = max(listed.items(), key=lambda item: area([item[1]], most))
    print(f"\nthe best of the list alone, {best[0]} with {', '.join(best[1:])}: {area([value], most) / whole:.1%}")


def main(all_folder, found_folder):
    random.seed(1)
    everything = (read_table if all_folder.endswith(".csv") else read)(all_folder)
    found = read(found_folder)
    world = {parse(key[0]): value for key, value in everything.items()}
    ours = in_world(found, everything)
    most = MOST * min(size for size, _ in (*everything.values(), *ours))
    whole = area([*everything.values(), *ours], most)
    print(f"{len(everything)} formats; they reach {area(everything.values(), most) / whole:.1%} of the area of all measurements")

    creator.create("Fitness", base.Fitness, weights=(-1.0, 1.0))
    creator.create("Individual", tuple, fitness=creator.Fitness)
    evolved = []
    for _ in range(RUNS):
        evolved.append([])
        evolve(world, evolved[-1])
    drawn = [random.sample(list(world), min(COUNTS[-1], len(world))) for _ in range(RUNS)]
    evolution, chance = mean_shares(evolved, world, most, whole), mean_shares(drawn, world, most, whole)

    print(f"\n| Measurements | voxc search, {len(ours)} in all | NSGA-II, mean of {RUNS} runs | random, mean of {RUNS} draws |\n|---:|---:|---:|---:|")
    for count in COUNTS:
        row = (area(ours[:count], most) / whole if count <= len(ours) else None, evolution.get(count), chance.get(count))
        print(f"| {count} | " + " | ".join("" if share is None else f"{share:.1%}" for share in row) + " |")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    (beside_list if len(sys.argv) == 2 else main)(*sys.argv[1:])
