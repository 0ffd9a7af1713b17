# SPDX-License-Identifier: GPL-3.0-or-later
"""Where one piece stands in the room: each function says whether the piece meets the wish."""

import math
from itertools import combinations

import geometry
import things
from plan import Opening, Piece, Plan, Point, Wall

Wish = dict


def side_of_room(plan: Plan, side: str) -> Point:
    """Unit vector to the left or right of who comes in through the first door; of (0, 0) when there is none."""
    doors = plan.openings_of("door")
    if not doors:
        return 0.0, 0.0
    x, y = doors[0].wall.outward
    # Who comes in looks inward.
    return (y, -x) if side == "left" else (-y, x)


def walls_named(plan: Plan, name: str) -> list[Wall]:
    """North, east, south, west; left or right as one comes in; any; longest, whichever walls that are."""
    if name == "any":
        return plan.walls
    if name == "longest":
        longest_m = max(wall.length_m for wall in plan.walls)
        return [wall for wall in plan.walls if wall.length_m > longest_m - 0.05]
    if name in ("left", "right"):
        x, y = side_of_room(plan, name)
        return [wall for wall in plan.walls if wall.outward[0] * x + wall.outward[1] * y > 0.7]
    return [wall for wall in plan.walls if wall.compass == name]


def at_wall(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Its outline, or with `back` the middle of its back, within `within_m`; its middle `centred_m` from the wall's."""
    distance_m = geometry.back_to_wall_m if wish["back"] else geometry.to_wall_m
    for wall in walls_named(plan, wish["wall"]):
        along_m = sum((p - q) * u for p, q, u in zip(piece.middle_m, wall.at_m(wall.length_m / 2), wall.along))
        centred = wish["centred_m"] is None or abs(along_m) <= wish["centred_m"]
        if distance_m(piece, wall) <= wish["within_m"] and centred:
            return True
    return False


def _corners_of(plan: Plan, piece: Piece, within_m: float) -> list[tuple[Wall, Wall]]:
    """The corners of the room where it stands: within that of both walls."""
    close = [wall for wall in plan.walls if geometry.to_wall_m(piece, wall) <= within_m]
    return [(one, other) for one, other in combinations(close, 2)
            if one.end_m == other.begin_m or other.end_m == one.begin_m]


def in_corner(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Close to two walls that meet; on that side as one comes in; close to such an opening."""
    corners = _corners_of(plan, piece, wish["within_m"])
    if wish["side"] is not None:
        wanted = walls_named(plan, wish["side"])
        corners = [corner for corner in corners if any(wall in wanted for wall in corner)]
    if wish["opening"] is not None:
        return bool(corners) and at_opening(plan, piece, {**wish, "within_m": wish["opening_m"], "widest": False})
    return bool(corners)


def _corner_point(corner: tuple[Wall, Wall]) -> Point:
    one, other = corner
    return one.end_m if one.end_m == other.begin_m else other.end_m


def opposite_corner(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """In another corner than the other, and not nearer to it than the room is wide."""
    width_m = min(plan.size_m())
    others = [_corner_point(corner) for other in things.select(plan, wish["to"]) if other is not piece
              for corner in _corners_of(plan, other, wish["within_m"])]
    own = [_corner_point(corner) for corner in _corners_of(plan, piece, wish["within_m"])]
    return any(math.dist(p, q) > width_m - 0.01 for p in own for q in others)


def central(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Its middle within this share of width and depth of the room's middle."""
    xs, ys = zip(*(wall.begin_m for wall in plan.walls))
    width_m, depth_m = plan.size_m()
    return (abs(piece.x_m - (min(xs) + max(xs)) / 2) < wish["within_share"] * width_m
            and abs(piece.y_m - (min(ys) + max(ys)) / 2) < wish["within_share"] * depth_m)


def at_opening(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Near one; with `widest`, near the widest of its kind: a garden door among doors."""
    openings = plan.openings_of(wish["opening"])
    if wish["widest"] and openings:
        openings = [max(openings, key=lambda one: one.width_m)]
    return any(geometry.to_opening_m(piece, one) <= wish["within_m"] for one in openings)


def _before(piece: Piece, opening: Opening, middle: bool) -> bool:
    width_m = opening.width_m
    if middle:
        return 0 <= geometry.along_opening_m(piece.middle_m, opening) <= width_m
    along_m = [geometry.along_opening_m(corner, opening) for corner in piece.corners_m()]
    return min(max(along_m), width_m) - max(min(along_m), 0.0) > 0.1


def before_opening(plan: Plan, piece: Piece, wish: Wish) -> bool:
    """Within `within_m` of it and before 0.1 m of it or more; with `middle`, its own middle is before it."""
    return any(geometry.to_opening_m(piece, one) <= wish["within_m"] and _before(piece, one, wish["middle"])
               for one in plan.openings_of(wish["opening"]))
