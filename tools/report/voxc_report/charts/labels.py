"""Names beside points, placed so that none covers another, a point, or what else is taken.

A box is left, top, right, bottom in pixels; many are an array of rows. Names are tried at places around their point, and stand
where they cover least.
"""
from dataclasses import dataclass

import numpy

HEIGHT = 1.2  # Of a line of text, in font sizes.
DESCENT = 0.3  # From the bottom of a line to its baseline, likewise.
WIDTH = 0.56  # Of a letter in the common sans-serif fonts, likewise.
POINT = 0.55  # Of what a point takes from its middle, likewise.
ROUNDS = 4
LEADER_PIECES = 12
CLOSE_PLACES = 4


@dataclass
class Label:
    text: str
    x: float  # The point.
    y: float


@dataclass
class Placed:
    label: Label
    box: numpy.ndarray
    size: float
    covered: float = 0  # How much it covers, mostly: an area in square pixels.

    @property
    def baseline(self):
        return self.box[3] - DESCENT * self.size

    @property
    def has_leader(self):
        """Whether it stands so far off that a line should lead to it."""
        return abs((self.box[1] + self.box[3]) / 2 - self.label.y) > 1.5 * self.size

    @property
    def leader_end(self):
        return leader_end(self.label, self.box, self.size)

    @property
    def boxes(self):
        """What it takes: the text, and pieces of its leader."""
        return numpy.vstack([self.box, leader_boxes(self.label, self.box, self.size)]) if self.has_leader else self.box[None]


def text_width(text, size):
    return WIDTH * size * len(text)


def around(x, y, reach):
    return [x - reach, y - reach, x + reach, y + reach]


def as_boxes(rows):
    return numpy.array(rows, float).reshape(-1, 4)


def overlaps(boxes, others):
    """The area that each box has in common with each of the others."""
    low = numpy.maximum(boxes[:, None, :2], others[None, :, :2])
    high = numpy.minimum(boxes[:, None, 2:], others[None, :, 2:])
    return numpy.prod(numpy.clip(high - low, 0, None), axis=2)


def outside(boxes, frame):
    """The area of each box that lies outside the frame."""
    return numpy.prod(boxes[:, 2:] - boxes[:, :2], axis=1) - overlaps(boxes, as_boxes([frame]))[:, 0]


def places(label, size):
    """Where a name is tried, best first: right, left, above, below, beside and a little up or down, then further up and down."""
    x, y, gap, width = label.x, label.y, 0.9 * size, text_width(label.text, size)
    right, left, middle = x + gap, x - gap - width, x - width / 2
    corners = [(right, y), (left, y), (middle, y - 1.3 * size), (middle, y + 1.3 * size)]
    for side in (-0.9, 0.9):
        corners += [(x - 0.5 * gap - width, y + side * size), (x + 0.5 * gap, y + side * size)]
    for row in range(1, 9):
        for side in (-1, 1):
            line = y + side * (0.6 + 1.3 * row) * size
            corners += [(middle, line), (right, line), (left, line)]
    half = HEIGHT * size / 2
    return as_boxes([(edge, line - half, edge + width, line + half) for edge, line in corners])


def leader_end(label, box, size):
    x = min(max(label.x, box[0] + 0.5 * size), box[2] - 0.5 * size)
    return x, box[3] if box[3] < label.y else box[1]


def leader_boxes(label, box, size):
    """Small boxes along the line from a point to its name."""
    x, y = leader_end(label, box, size)
    shares = [piece / LEADER_PIECES for piece in range(2, LEADER_PIECES)]
    return as_boxes([around(label.x + share * (x - label.x), label.y + share * (y - label.y), 0.15 * size) for share in shares])


def costs(label, boxes, taken, frame, size):
    """How much a name would cover or leave the frame at each of the boxes; crossing something with a leader counts as much as
    covering it, and a long leader a little by itself."""
    result = outside(boxes, frame) + overlaps(boxes, taken).sum(axis=1)
    far = [i for i, box in enumerate(boxes) if Placed(label, box, size).has_leader]
    if far:
        leaders = numpy.vstack([leader_boxes(label, boxes[i], size) for i in far])
        ends = numpy.array([leader_end(label, boxes[i], size) for i in far])
        result[far] += 10 * overlaps(leaders, taken).sum(axis=1).reshape(len(far), -1).sum(axis=1)
        result[far] += 0.5 * numpy.hypot(ends[:, 0] - label.x, ends[:, 1] - label.y)
    return result


def best_place(label, taken, frame, size):
    boxes = places(label, size)
    found = costs(label, boxes, taken, frame, size)
    best = int(numpy.argmin(found))
    return Placed(label, boxes[best], size, found[best])


def point_boxes(labels, size):
    return as_boxes([around(label.x, label.y, POINT * size) for label in labels])


def place_labels(labels, frame, size, taken):
    """Places names in their order. One for which no place is left stands where it covers least."""
    taken = numpy.vstack([taken, point_boxes(labels, size)])
    placed = [None] * len(labels)
    # Each is placed anew, now that it knows where the others went, until they stay.
    for _ in range(ROUNDS):
        before = [other.box.tolist() if other else None for other in placed]
        for i, label in enumerate(labels):
            others = [other.boxes for j, other in enumerate(placed) if other and j != i]
            placed[i] = best_place(label, numpy.vstack([taken, *others]), frame, size)
        if before == [other.box.tolist() for other in placed]:
            break
    return placed


def place_where_free(labels, frame, size, taken, most):
    """At most so many names for which there is room right beside their points; earlier ones take their places first."""
    taken = numpy.vstack([taken, point_boxes(labels, size)])
    placed = []
    for label in labels:
        if len(placed) == most:
            break
        boxes = places(label, size)[:CLOSE_PLACES]
        is_free = (outside(boxes, frame) <= 1e-9) & (overlaps(boxes, taken).sum(axis=1) <= 0)
        if is_free.any():
            placed.append(Placed(label, boxes[int(numpy.argmax(is_free))], size))
            taken = numpy.vstack([taken, placed[-1].box])
    return placed
