"""Joins the loose straight pieces of a drawing into few long lines."""

import math
from collections import defaultdict
from collections.abc import Iterable

Point = tuple[float, float]
Piece = tuple[Point, Point]

DECIMALS = 3  # of a metre, to which points are rounded
SAME_ANGLE = 1e-4  # rad
TOUCHING = 1e-3  # m


def join_pieces(pieces: Iterable[Piece]) -> list[list[Point]]:
    """Return the pieces (m) as lines: merges collinear pieces that touch, then chains pieces whose ends meet.

    Points are rounded to a millimetre; repeated pieces and pieces of length zero are left out.
    """
    return chain_pieces(_merge_collinear(pieces))


def chain_pieces(pieces: Iterable[Piece]) -> list[list[Point]]:
    """Return lines that contain each piece exactly once; a line begins at an open end where it has one."""
    edges = list(dict.fromkeys(tuple(sorted(piece)) for piece in _round(pieces)))
    at: dict[Point, list[int]] = defaultdict(list)
    for number, piece in enumerate(edges):
        for end in piece:
            at[end].append(number)
    unused = set(range(len(edges)))
    lines = []
    open_ends = [place for place, numbers in at.items() if len(numbers) % 2]
    for start in (*open_ends, *at):
        while line := _walk(start, edges, at, unused):
            lines.append(line)
    return lines


def _walk(start: Point, edges: list[tuple[Point, ...]], at: dict[Point, list[int]], unused: set[int]) -> list[Point]:
    """Return the line from `start` along unused edges to its end; an empty list when no unused edge is at `start`."""
    line: list[Point] = []
    point = start
    while True:
        numbers = at[point]
        while numbers and numbers[-1] not in unused:
            numbers.pop()
        if not numbers:
            return line
        number = numbers.pop()
        unused.discard(number)
        a, b = edges[number]
        next_point = b if a == point else a
        line = [*line, next_point] if line else [point, next_point]
        point = next_point


def _round(pieces: Iterable[Piece]) -> Iterable[Piece]:
    for (ax, ay), (bx, by) in pieces:
        a, b = (round(ax, DECIMALS), round(ay, DECIMALS)), (round(bx, DECIMALS), round(by, DECIMALS))
        if a != b:
            yield a, b


def _merge_collinear(pieces: Iterable[Piece]) -> list[Piece]:
    """Return the pieces, collinear ones that touch or overlap merged into one."""
    on_line: dict[tuple[int, int], list[tuple[float, float, Piece]]] = defaultdict(list)
    for a, b in _round(pieces):
        if b < a:
            a, b = b, a  # noqa: PLW2901  (towards larger x, because opposite directions are one line)
        turn = round(math.atan2(b[1] - a[1], b[0] - a[0]) / SAME_ANGLE)
        angle = turn * SAME_ANGLE
        cos, sin = math.cos(angle), math.sin(angle)
        beside = round(((a[1] + b[1]) * cos - (a[0] + b[0]) * sin) / 2 / TOUCHING)
        along = a[0] * cos + a[1] * sin, b[0] * cos + b[1] * sin
        on_line[turn, beside].append((*along, (a, b)))
    merged = []
    for parts in on_line.values():
        parts.sort()
        _, reach, (first, last) = parts[0]
        for start, end, (a, b) in parts[1:]:
            if start > reach + TOUCHING:
                merged.append((first, last))
                first, last, reach = a, b, end
            elif end > reach:
                last, reach = b, end
        merged.append((first, last))
    return merged
