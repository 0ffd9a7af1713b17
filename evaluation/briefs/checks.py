# SPDX-License-Identifier: GPL-3.0-or-later
"""The closed vocabulary of checks: what a wish of a brief can ask of a plan.

A check of pieces looks at each piece of the selector `of` by itself; how many must meet it is said by `exactly`,
`at_least`, `at_most` or `all` (at least 1). Distances are between outlines unless said otherwise.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import places
import relations
import things
from plan import Opening, Piece, Plan

Wish = dict

WALLS = ("north", "east", "south", "west")
SIDES = ("left", "right")
OPENINGS = ("door", "window")
NUMBERS = ("exactly", "at_least", "at_most")
BOUNDS = (*NUMBERS, "all")


@dataclass(frozen=True)
class Check:
    """`fields` maps what a wish must say to its kind, `options` what it may say to its default."""

    judge: Callable[[Plan, Wish], bool]
    fields: dict[str, str]
    options: dict[str, object] = field(default_factory=dict)
    counts: bool = True


def _meets_number(count: int, wish: Wish, total: int | None = None) -> bool:
    if wish.get("all"):
        return total is not None and total > 0 and count == total
    if not any(number in wish for number in NUMBERS):
        return count >= 1
    return (wish.get("exactly", count) == count and wish.get("at_least", count) <= count
            and wish.get("at_most", count) >= count)


def _of_pieces(meets: Callable[[Plan, Piece, Wish], bool]) -> Callable[[Plan, Wish], bool]:
    def judge(plan: Plan, wish: Wish) -> bool:
        pieces = things.select(plan, wish["of"])
        return _meets_number(sum(meets(plan, piece, wish) for piece in pieces), wish, len(pieces))

    return judge


def _count(plan: Plan, wish: Wish) -> bool:
    return _meets_number(len(things.select(plan, wish["of"])), wish)


def _seats(plan: Plan, wish: Wish) -> bool:
    return _meets_number(things.seat_count(plan), wish)


def _opening_count(plan: Plan, wish: Wish) -> bool:
    return _meets_number(len(plan.openings_of(wish["opening"])), wish)


def _opening_walls(plan: Plan, wish: Wish) -> bool:
    return {one.wall.compass for one in plan.openings_of(wish["opening"])} == set(wish["walls"])


def _opposite(one: Opening, other: Opening) -> bool:
    (ax, ay), (bx, by) = one.wall.outward, other.wall.outward
    return ax * bx + ay * by < -0.9


def _opening_opposite(plan: Plan, wish: Wish) -> bool:
    others = plan.openings_of(wish["to_opening"])
    count = sum(any(_opposite(one, other) for other in others) for one in plan.openings_of(wish["opening"]))
    return _meets_number(count, wish)


def _opening_one_wall(plan: Plan, wish: Wish) -> bool:
    return len({one.wall for one in plan.openings_of(wish["opening"])}) == 1


def _room_size(plan: Plan, wish: Wish) -> bool:
    return all(abs(is_m - wanted_m) <= wish["within_m"]
               for is_m, wanted_m in zip(sorted(plan.size_m()), sorted(wish["sides_m"]), strict=True))


def _room_area(plan: Plan, wish: Wish) -> bool:
    return abs(plan.area_m2() - wish["area_m2"]) <= wish["within_m2"]


def _piece_size(_: Plan, piece: Piece, wish: Wish) -> bool:
    return all(abs(is_m - wanted_m) <= wish["within_m"]
               for is_m, wanted_m in zip(sorted((piece.width_m, piece.depth_m)), sorted(wish["sides_m"]), strict=True))


def _room_type(plan: Plan, wish: Wish) -> bool:
    return wish["contains"] in plan.room_type


def _in_row(plan: Plan, wish: Wish) -> bool:
    pieces = things.select(plan, wish["of"])
    spreads = (max(values) - min(values) for values in zip(*(piece.middle_m for piece in pieces)))
    return len(pieces) >= 2 and min(spreads) <= wish["within_m"]


def _same_direction(plan: Plan, wish: Wish) -> bool:
    pieces = things.select(plan, wish["of"])
    return len(pieces) >= 2 and all(
        relations.headings_agree(pieces[0], other, wish["within_deg"]) for other in pieces[1:])


CHECKS = {
    "count": Check(_count, {"of": "things"}),
    "piece_size": Check(_of_pieces(_piece_size), {"of": "things", "sides_m": "sides"}, {"within_m": 0.02}),
    "seats": Check(_seats, {}),
    "room_type": Check(_room_type, {"contains": "text"}, counts=False),
    "room_size": Check(_room_size, {"sides_m": "sides"}, {"within_m": 0.02}, counts=False),
    "room_area": Check(_room_area, {"area_m2": "number"}, {"within_m2": 0.1}, counts=False),
    "opening_count": Check(_opening_count, {"opening": "opening"}),
    "opening_walls": Check(_opening_walls, {"opening": "opening", "walls": "walls"}, counts=False),
    "opening_opposite": Check(_opening_opposite, {"opening": "opening", "to_opening": "opening"}),
    "opening_one_wall": Check(_opening_one_wall, {"opening": "opening"}, counts=False),
    "at_wall": Check(_of_pieces(places.at_wall), {"of": "things", "wall": "wall"},
                     {"within_m": 0.35, "back": False, "centred_m": None}),
    "in_corner": Check(_of_pieces(places.in_corner), {"of": "things"},
                       {"within_m": 0.4, "side": None, "opening": None, "opening_m": 0.9}),
    "opposite_corner": Check(_of_pieces(places.opposite_corner), {"of": "things", "to": "things"}, {"within_m": 0.4}),
    "central": Check(_of_pieces(places.central), {"of": "things"}, {"within_share": 0.2}),
    "at_opening": Check(_of_pieces(places.at_opening), {"of": "things", "opening": "opening"},
                        {"within_m": 0.6, "widest": False}),
    "before_opening": Check(_of_pieces(places.before_opening), {"of": "things", "opening": "opening"},
                            {"within_m": 0.35, "middle": False}),
    "near": Check(_of_pieces(relations.near), {"of": "things", "to": "things"}, {"within_m": 0.5}),
    "between": Check(_of_pieces(relations.between), {"of": "things", "ends": "ends"}, {"within_m": 0.9}),
    "facing": Check(_of_pieces(relations.facing), {"of": "things", "to": "target"},
                    {"within_deg": 40.0, "within_m": None, "each_other": False}),
    "opposed": Check(_of_pieces(relations.opposed), {"of": "things", "to": "things"},
                     {"within_deg": 35.0, "within_m": 2.5}),
    "in_front": Check(_of_pieces(relations.in_front), {"of": "things", "to": "things"},
                      {"within_m": 0.6, "within_deg": 45.0}),
    "behind": Check(_of_pieces(relations.behind), {"of": "things", "to": "things"},
                    {"within_m": 0.4, "within_deg": 60.0}),
    "beside": Check(_of_pieces(relations.beside), {"of": "things", "to": "things", "side": "hand"}, {"within_m": 0.6}),
    "in_row": Check(_in_row, {"of": "things"}, {"within_m": 0.15}, counts=False),
    "same_direction": Check(_same_direction, {"of": "things"}, {"within_deg": 10.0}, counts=False),
}


def holds(plan: Plan, wish: Wish) -> bool:
    """Whether the plan meets a wish that has been read by wishes.py."""
    check = CHECKS[wish["check"]]
    return check.judge(plan, {**check.options, **wish})
