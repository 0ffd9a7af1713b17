# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane geometry of rooms and furniture, in metres and radians: x east, y north, angles counter-clockwise.

Polygons are lists of corners, counter-clockwise. A convex one can cut any other, which is all that areas in common
need.
"""

import math
from dataclasses import dataclass

Point = tuple[float, float]
Polygon = list[Point]
# Least x and y, most x and y.
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Pose:
    """Where the middle of an object is and where it looks; heading 0 faces north."""

    x_m: float
    y_m: float
    heading_rad: float

    @property
    def centre(self) -> Point:
        return (self.x_m, self.y_m)

    @property
    def front(self) -> Point:
        """Unit vector straight ahead."""
        return (-math.sin(self.heading_rad), math.cos(self.heading_rad))

    @property
    def right(self) -> Point:
        """Unit vector to its right."""
        return (math.cos(self.heading_rad), math.sin(self.heading_rad))

    def at(self, right_m: float, front_m: float) -> Point:
        """A point given in the object's own frame."""
        (rx, ry), (fx, fy) = self.right, self.front
        return (self.x_m + right_m * rx + front_m * fx, self.y_m + right_m * ry + front_m * fy)


def rectangle(pose: Pose, width_m: float, depth_m: float) -> Polygon:
    """Back left, back right, front right, front left."""
    half_w, half_d = width_m / 2, depth_m / 2
    return [pose.at(-half_w, -half_d), pose.at(half_w, -half_d), pose.at(half_w, half_d), pose.at(-half_w, half_d)]


def heading_of(front: Point) -> float:
    """The heading in [0, 2 pi) that faces along a vector."""
    heading = math.atan2(-front[0], front[1]) % math.tau
    return heading if heading < math.tau else 0.0  # a tiny negative angle rounds up to the full turn


def area_m2(polygon: Polygon) -> float:
    twice = 0.0
    for i, (x, y) in enumerate(polygon):
        twice += polygon[i - 1][0] * y - x * polygon[i - 1][1]
    return twice / 2


def cut(polygon: Polygon, a: Point, b: Point) -> Polygon:
    """The part of a polygon that lies left of the line from `a` to `b` (Sutherland and Hodgman)."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    left = [dx * (y - a[1]) - dy * (x - a[0]) for x, y in polygon]
    part: Polygon = []
    for i, point in enumerate(polygon):
        before, at = left[i - 1], left[i]
        if (before < 0) != (at < 0):
            share = before / (before - at)
            last = polygon[i - 1]
            part.append((last[0] + share * (point[0] - last[0]), last[1] + share * (point[1] - last[1])))
        if at >= 0:
            part.append(point)
    return part


def common_m2(polygon: Polygon, convex: Polygon) -> float:
    """The area that a polygon has in common with a convex one."""
    part = polygon
    for i, corner in enumerate(convex):
        part = cut(part, convex[i - 1], corner)
        if not part:
            return 0.0
    return max(area_m2(part), 0.0)


def bounds(polygon: Polygon) -> Box:
    xs, ys = [x for x, _ in polygon], [y for _, y in polygon]
    return (min(xs), min(ys), max(xs), max(ys))


def apart(a: Box, b: Box) -> bool:
    """Whether two boxes have no area in common."""
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def depth_m(a: Polygon, b: Polygon) -> float:
    """The shortest push that parts two convex polygons; 0 when they do not overlap."""
    least = math.inf
    for polygon in (a, b):
        for i, corner in enumerate(polygon):
            nx, ny = corner[1] - polygon[i - 1][1], polygon[i - 1][0] - corner[0]
            length = math.hypot(nx, ny)
            reach_a = [(x * nx + y * ny) / length for x, y in a]
            reach_b = [(x * nx + y * ny) / length for x, y in b]
            least = min(least, max(reach_a) - min(reach_b), max(reach_b) - min(reach_a))
    return max(least, 0.0)
