# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances and angles between things on a plan."""

import math

from plan import Opening, Piece, Point, Wall

Segment = tuple[Point, Point]


def distance_to_segment_m(p: Point, segment: Segment) -> float:
    (ax, ay), (bx, by) = segment
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy
    share = 0.0 if length2 == 0 else max(0.0, min(1.0, ((p[0] - ax) * dx + (p[1] - ay) * dy) / length2))
    return math.dist(p, (ax + share * dx, ay + share * dy))


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _cross(one: Segment, other: Segment) -> bool:
    (a, b), (c, d) = one, other
    return _turn(a, b, c) * _turn(a, b, d) < 0 and _turn(c, d, a) * _turn(c, d, b) < 0


def _holds(corners: list[Point], p: Point) -> bool:
    """Whether the rectangle, corners counter-clockwise, holds the point."""
    return all(_turn(corners[i], corners[(i + 1) % 4], p) >= 0 for i in range(4))


def _edges(corners: list[Point]) -> list[Segment]:
    return [(corners[i], corners[(i + 1) % 4]) for i in range(4)]


def gap_to_segment_m(piece: Piece, segment: Segment) -> float:
    """From the piece's outline to the segment; 0 when they touch."""
    corners = piece.corners_m()
    if any(_cross(edge, segment) for edge in _edges(corners)) or any(_holds(corners, p) for p in segment):
        return 0.0
    return min([distance_to_segment_m(corner, segment) for corner in corners]
               + [distance_to_segment_m(p, edge) for p in segment for edge in _edges(corners)])


def gap_m(one: Piece, other: Piece) -> float:
    """Between the outlines of two pieces; 0 when they touch or one stands in the other."""
    mine, theirs = one.corners_m(), other.corners_m()
    if any(_holds(mine, corner) for corner in theirs) or any(_holds(theirs, corner) for corner in mine):
        return 0.0
    return min(gap_to_segment_m(one, edge) for edge in _edges(theirs))


def off_front_deg(piece: Piece, p: Point) -> float:
    """How far the point lies from straight ahead of the piece's middle, 0 to 180."""
    x, y = p[0] - piece.x_m, p[1] - piece.y_m
    ahead = x * piece.front[0] + y * piece.front[1]
    return abs(math.degrees(math.atan2(x * piece.right[0] + y * piece.right[1], ahead)))


def to_right_m(piece: Piece, p: Point) -> float:
    """How far the point lies to the right hand of who sits in the piece; negative to the left."""
    return (p[0] - piece.x_m) * piece.right[0] + (p[1] - piece.y_m) * piece.right[1]


def between_deg(one_rad: float, other_rad: float) -> float:
    """Between two headings, 0 to 180."""
    return abs(math.degrees(math.remainder(one_rad - other_rad, 2 * math.pi)))


def to_wall_m(piece: Piece, wall: Wall) -> float:
    return gap_to_segment_m(piece, (wall.begin_m, wall.end_m))


def back_to_wall_m(piece: Piece, wall: Wall) -> float:
    """From the middle of the back edge."""
    left, right = piece.corners_m()[:2]
    return distance_to_segment_m(((left[0] + right[0]) / 2, (left[1] + right[1]) / 2), (wall.begin_m, wall.end_m))


def to_opening_m(piece: Piece, opening: Opening) -> float:
    return gap_to_segment_m(piece, (opening.begin_m, opening.end_m))


def along_opening_m(p: Point, opening: Opening) -> float:
    """From the opening's begin along its wall."""
    along = opening.wall.along
    return (p[0] - opening.begin_m[0]) * along[0] + (p[1] - opening.begin_m[1]) * along[1]
