# SPDX-License-Identifier: GPL-3.0-or-later
"""Where one piece stands to others: each function says whether the piece meets the wish."""

import math

import geometry
import things
from plan import Piece, Plan, Point

Wish = dict


def _others(plan: Plan, piece: Piece, wish: Wish) -> list[Piece]:
    return [other for other in things.select(plan, wish["to"]) if other is not piece]


def near(plan: Plan, piece: Piece, wish: Wish) -> bool:
    return any(geometry.gap_m(piece, other) <= wish["within_m"] for other in _others(plan, piece, wish))


def _points(plan: Plan, target: str | list[str]) -> list[Point]:
    """The middles of the things, doors or windows that are meant."""
    if target in ("door", "window"):
        return [opening.middle_m for opening in plan.openings_of(target)]
    return [piece.middle_m for piece in things.select(plan, target)]


def _on_the_way(p: Point, begin: Point, end: Point, within_m: float) -> bool:
    length_m = math.dist(begin, end)
    if length_m == 0:
        return False
    ux, uy = (end[0] - begin[0]) / length_m, (end[1] - begin[1]) / length_m
    along_m = (p[0] - begin[0]) * ux + (p[1] - begin[1]) * uy
    across_m = abs((p[0] - begin[0]) * uy - (p[1] - begin[1]) * ux)
    return 0.25 < along_m / length_m < 0.75 and across_m <= within_m


def between(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Over the middle half of the line from one end to the other, `within_m` aside at most."""
    first, second = (_points(plan, end) for end in wish["ends"])
    return any(_on_the_way(piece.middle_m, p, q, wish["within_m"])
               for p in first for q in second if piece.middle_m not in (p, q))


def _looks_at(piece: Piece, p: Point, within_deg: float) -> bool:
    return geometry.off_front_deg(piece, p) <= within_deg


def facing(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Looks at the middle of one; with `each_other` that one looks at it, too."""
    if wish["to"] in ("door", "window"):
        return any(_looks_at(piece, p, wish["within_deg"]) for p in _points(plan, wish["to"]))
    return any(_looks_at(piece, other.middle_m, wish["within_deg"])
               and (not wish["each_other"] or _looks_at(other, piece.middle_m, wish["within_deg"]))
               and (wish["within_m"] is None or geometry.gap_m(piece, other) <= wish["within_m"])
               for other in _others(plan, piece, wish))


def opposed(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Looks the other way than the other, which is straight before or behind it: desks of two who sit face to face."""
    def across(other: Piece) -> bool:
        off_deg = geometry.off_front_deg(piece, other.middle_m)
        return min(off_deg, 180 - off_deg) <= wish["within_deg"]

    return any(180 - geometry.between_deg(piece.heading_rad, other.heading_rad) <= wish["within_deg"] and across(other)
               and geometry.gap_m(piece, other) <= wish["within_m"] for other in _others(plan, piece, wish))


def in_front(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Where the other looks."""
    return any(geometry.off_front_deg(other, piece.middle_m) <= wish["within_deg"]
               and geometry.gap_m(piece, other) <= wish["within_m"] for other in _others(plan, piece, wish))


def behind(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Where the other turns its back."""
    return any(geometry.off_front_deg(other, piece.middle_m) >= 180 - wish["within_deg"]
               and geometry.gap_m(piece, other) <= wish["within_m"] for other in _others(plan, piece, wish))


def beside(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """At the left or right hand of who sits in the other; either, where words do not say who looks."""
    signs = {"left": (-1,), "right": (1,), "either": (-1, 1)}[wish["side"]]
    return any(max(sign * geometry.to_right_m(other, piece.middle_m) for sign in signs) > 0.3
               and geometry.gap_m(piece, other) <= wish["within_m"] for other in _others(plan, piece, wish))


def headings_agree(one: Piece, other: Piece, within_deg: float) -> bool:
    return geometry.between_deg(one.heading_rad, other.heading_rad) <= within_deg
