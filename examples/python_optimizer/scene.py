# SPDX-License-Identifier: GPL-3.0-or-later
"""The problem as the search sees it: a layout graph that was checked, as plain values."""

import math
from dataclasses import dataclass

from flair import v1

from geometry import Point, Polygon, heading_of

# Floor in front of a door that does not open into the room; one that does needs what its leaf sweeps as well.
PASSAGE_M = 0.6
_ARC_PIECES = 8


@dataclass(frozen=True)
class Wall:
    """One edge of the floor, walked counter-clockwise: the room lies on its left."""

    name: str
    start: Point
    end: Point

    @property
    def length_m(self) -> float:
        return math.dist(self.start, self.end)

    @property
    def along(self) -> Point:
        return ((self.end[0] - self.start[0]) / self.length_m, (self.end[1] - self.start[1]) / self.length_m)

    @property
    def inward(self) -> Point:
        """Unit vector into the room."""
        return (-self.along[1], self.along[0])

    @property
    def heading_rad(self) -> float:
        """Of what stands with its back on this wall."""
        return heading_of(self.inward)

    def at(self, along_m: float, inward_m: float) -> Point:
        (ax, ay), (nx, ny) = self.along, self.inward
        return (self.start[0] + along_m * ax + inward_m * nx, self.start[1] + along_m * ay + inward_m * ny)


class Scene:
    """Room and objects. Objects are known by their index in the graph's list."""

    def __init__(self, graph: v1.LayoutGraph) -> None:
        self.graph = graph
        self.objects = list(graph.object_list.objects)
        self.index = {item.id: i for i, item in enumerate(self.objects)}
        self._hosts = [self._hosts_of(i) for i in range(len(self.objects))]
        self._undersides_m = [self._underside_of(i) for i in range(len(self.objects))]
        self.floor: Polygon = [(corner.x_m, corner.y_m) for corner in graph.room.floor.vertices]
        ends = self.floor[1:] + self.floor[:1]
        self.walls = [Wall(wall.name, *edge) for wall, edge in zip(graph.room.walls, zip(self.floor, ends))]
        self._wall = {wall.name: wall for wall in self.walls}
        doors = [item for item in graph.room.openings if item.kind == v1.OpeningKind.OPENING_KIND_DOOR]
        # Convex areas that must stay free: what leaves sweep, and the passage before each door.
        self.swings = [self._swing(door) for door in doors if door.leaf.swing == v1.DoorSwing.DOOR_SWING_INWARD]
        self.door_areas = self.swings + [self._passage(door) for door in doors]

    def stands(self, i: int) -> bool:
        """Whether it stands on the floor and is in the way."""
        return self.objects[i].kind == v1.ObjectKind.OBJECT_KIND_FLOOR and not self.objects[i].walk_over

    def hosts(self, i: int) -> list[int]:
        """What it stands on or belongs to, what that stands on, and so on; a circle ends where it closes."""
        return self._hosts[i]

    def host(self, i: int) -> int | None:
        """What it stands on or belongs to."""
        return self._hosts[i][0] if self._hosts[i] else None

    def underside_m(self, i: int) -> float:
        """Height of its underside above the floor."""
        return self._undersides_m[i]

    def _hosts_of(self, i: int) -> list[int]:
        chain = [i]
        while (host := self.index.get(self.objects[chain[-1]].host_id)) is not None and host not in chain:
            chain.append(host)
        return chain[1:]

    def _underside_of(self, i: int) -> float:
        height = self.objects[i].elevation_m
        for host in self._hosts[i]:
            if self.objects[i].kind != v1.ObjectKind.OBJECT_KIND_SURFACE:
                break
            i = host
            height += self.objects[i].height_m + self.objects[i].elevation_m
        return height

    def opening_on_wall(self, opening: v1.Opening) -> tuple[Wall, float, float]:
        """The wall, and where the opening begins and ends along it."""
        return self._wall[opening.wall], opening.offset_m, opening.offset_m + opening.width_m

    def wall(self, name: str) -> Wall | None:
        return self._wall.get(name)

    def _passage(self, door: v1.Opening) -> Polygon:
        wall, start, end = self.opening_on_wall(door)
        return [wall.at(start, 0), wall.at(end, 0), wall.at(end, PASSAGE_M), wall.at(start, PASSAGE_M)]

    def _swing(self, door: v1.Opening) -> Polygon:
        """The sector around the hinge, its arc replaced by tangents so that the arc lies within."""
        wall, start, end = self.opening_on_wall(door)
        at_start = door.leaf.hinge == v1.HingeSide.HINGE_SIDE_START
        hinge = wall.at(start if at_start else end, 0)
        closed = math.atan2(wall.along[1], wall.along[0]) + (0 if at_start else math.pi)
        step = door.leaf.swing_angle_rad / _ARC_PIECES * (1 if at_start else -1)
        tangent_m = door.width_m / math.cos(step / 2)
        rays = [(0.0, door.width_m), *((k + 0.5, tangent_m) for k in range(_ARC_PIECES)), (_ARC_PIECES, door.width_m)]
        arc = [(hinge[0] + radius_m * math.cos(closed + k * step), hinge[1] + radius_m * math.sin(closed + k * step))
               for k, radius_m in rays]
        return [hinge, *(arc if at_start else reversed(arc))]
