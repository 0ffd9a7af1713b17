# SPDX-License-Identifier: GPL-3.0-or-later
"""A furnished room as the judge sees it, read from layout.json.

Frame of the room: metres, x to the right (east), y up (north), angles counter-clockwise. A piece looks along its own y.
"""

import json
import math
from dataclasses import dataclass, field
from pathlib import Path

Point = tuple[float, float]


@dataclass(frozen=True)
class Piece:
    """One object and where it stands. `kind` is floor, wall, ceiling or surface."""

    name: str
    x_m: float
    y_m: float
    heading_rad: float
    width_m: float
    depth_m: float
    kind: str = "floor"
    walk_over: bool = False

    @property
    def middle_m(self) -> Point:
        return self.x_m, self.y_m

    @property
    def front(self) -> Point:
        """Unit vector to where it looks."""
        return -math.sin(self.heading_rad), math.cos(self.heading_rad)

    @property
    def right(self) -> Point:
        """Unit vector to the right hand of who sits in it."""
        return math.cos(self.heading_rad), math.sin(self.heading_rad)

    def corners_m(self) -> list[Point]:
        """Back left, back right, front right, front left."""
        (rx, ry), (fx, fy) = self.right, self.front
        halves = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        return [(self.x_m + u * self.width_m / 2 * rx + v * self.depth_m / 2 * fx,
                 self.y_m + u * self.width_m / 2 * ry + v * self.depth_m / 2 * fy) for u, v in halves]


@dataclass(frozen=True)
class Wall:
    """From `begin_m` to `end_m`, the room on its left hand."""

    begin_m: Point
    end_m: Point

    @property
    def length_m(self) -> float:
        return math.dist(self.begin_m, self.end_m)

    @property
    def along(self) -> Point:
        return ((self.end_m[0] - self.begin_m[0]) / self.length_m, (self.end_m[1] - self.begin_m[1]) / self.length_m)

    @property
    def outward(self) -> Point:
        return self.along[1], -self.along[0]

    @property
    def compass(self) -> str:
        """The side of the room that it is on: north, east, south or west."""
        x, y = self.outward
        if abs(x) > abs(y):
            return "east" if x > 0 else "west"
        return "north" if y > 0 else "south"

    def at_m(self, offset_m: float) -> Point:
        return self.begin_m[0] + offset_m * self.along[0], self.begin_m[1] + offset_m * self.along[1]


@dataclass(frozen=True)
class Opening:
    """A door or a window: `begin_m` and `end_m` on its wall."""

    kind: str
    wall: Wall
    begin_m: Point
    end_m: Point

    @property
    def middle_m(self) -> Point:
        return (self.begin_m[0] + self.end_m[0]) / 2, (self.begin_m[1] + self.end_m[1]) / 2

    @property
    def width_m(self) -> float:
        return math.dist(self.begin_m, self.end_m)


@dataclass(frozen=True)
class Plan:
    """`remarks` is what the design says of itself: diagnostics, what was left out, what was asked for and not met."""

    walls: list[Wall]
    room_type: str = ""
    openings: list[Opening] = field(default_factory=list)
    pieces: list[Piece] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)

    def openings_of(self, kind: str) -> list[Opening]:
        return [opening for opening in self.openings if opening.kind == kind]

    def size_m(self) -> Point:
        """Width and depth of the box around the floor."""
        xs, ys = zip(*(wall.begin_m for wall in self.walls))
        return max(xs) - min(xs), max(ys) - min(ys)

    def area_m2(self) -> float:
        return sum(a[0] * b[1] - b[0] * a[1] for a, b in ((wall.begin_m, wall.end_m) for wall in self.walls)) / 2


def read_plan(layout_path: Path, report_path: Path) -> Plan:
    """The plan of a design; layout.json leaves out what is zero."""
    layout = json.loads(layout_path.read_text(encoding="utf-8"))["solved_layout"]
    report = json.loads(report_path.read_text(encoding="utf-8"))["report"]
    room = layout["graph"]["room"]
    walls = _walls(room)
    openings = [_opening(one, walls) for one in room.get("openings", [])]
    return Plan(list(walls.values()), room.get("room_type", ""), openings, _pieces(layout), _remarks(layout, report))


def _walls(room: dict) -> dict[str, Wall]:
    vertices = [(point.get("x_m", 0.0), point.get("y_m", 0.0)) for point in room["floor"]["vertices"]]
    ends = vertices[1:] + vertices[:1]
    return {wall["name"]: Wall(begin, end) for wall, begin, end in zip(room["walls"], vertices, ends, strict=True)}


def _opening(opening: dict, walls: dict[str, Wall]) -> Opening:
    wall = walls[opening["wall"]]
    offset_m = opening.get("offset_m", 0.0)
    return Opening(opening["kind"].removeprefix("OPENING_KIND_").lower(), wall, wall.at_m(offset_m),
                   wall.at_m(offset_m + opening["width_m"]))


def _pieces(layout: dict) -> list[Piece]:
    objects = {one["id"]: one for one in layout["graph"]["object_list"].get("objects", [])}
    pieces = []
    for placement in layout.get("placements", []):
        one = objects[placement["object_id"]]
        pieces.append(Piece(one["name"], placement.get("x_m", 0.0), placement.get("y_m", 0.0),
                            placement.get("theta_rad", 0.0), one["width_m"], one["depth_m"],
                            one["kind"].removeprefix("OBJECT_KIND_").lower(), one.get("walk_over", False)))
    return pieces


# Said of nearly every brief, and of no wish in particular.
_OF_NO_WISH = {"size_assumed"}


def _remarks(layout: dict, report: dict) -> list[str]:
    """Sentences that the brief itself asks for and that do not hold are told in report.md in the brief's words."""
    graph = layout["graph"]
    remarks = [one["message"] for one in report.get("diagnostics", []) if one.get("code") not in _OF_NO_WISH]
    remarks += [f"{one['name']}: {one['reason']}" for one in graph["object_list"].get("omissions", [])]
    asked = {one["id"]: f"{one['text']} ({one['reason']})" for one in graph["constraint_list"].get("sentences", [])
             if one.get("origin") == "SENTENCE_ORIGIN_BRIEF"}
    sentences = {edge["id"]: asked.get(edge.get("sentence_id")) for edge in graph.get("edges", [])}
    return remarks + [sentences[one["edge_id"]] for one in layout.get("edge_outcomes", [])
                      if one["status"] != "OUTCOME_STATUS_SATISFIED" and sentences.get(one["edge_id"])]
