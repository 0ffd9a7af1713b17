# SPDX-License-Identifier: GPL-3.0-or-later
"""Places what does not stand on the floor, one after the other, when everything that does has its place.

Each thing tries the poses that its kind allows and takes the one with the least cost:
  walls      back on a wall at its height, a hand's width apart; near its host
  surfaces   on its host, in a grid; near its middle, or its back when it is not alone there
  ceilings   over its host, else in the middle of the room, or where that is free
  rugs       under its host, else in the middle of the room
"""

import math
from collections.abc import Callable, Iterator

from flair import v1

from functions import Poses
from geometry import Pose, apart, area_m2, bounds, common_m2, rectangle
from scene import Scene

_SPACING_M = 0.1
_GRID = 9
# What a square metre of overlap costs, beside 1 for a metre from where it would rather be.
_OVERLAP_FACTOR = 1e4
# Things whose heights meet by no more than this do not collide [m].
_TOUCH_M = 0.01
# Others stand on things on a surface that are no higher than this.
_CLOTH_M = 0.05

_KIND = v1.ObjectKind


def collide(scene: Scene, i: int, k: int) -> bool:
    """Whether two objects may not be in the same place: not rugs and cloths, not host and guest, not far in height."""
    a, b = scene.objects[i], scene.objects[k]
    if _lies_flat(a) or _lies_flat(b) or scene.host(i) == k or scene.host(k) == i:
        return False
    low_a, low_b = scene.underside_m(i), scene.underside_m(k)
    return min(low_a + a.height_m, low_b + b.height_m) - max(low_a, low_b) > _TOUCH_M


def _lies_flat(item: v1.Object) -> bool:
    return item.walk_over or (item.kind == _KIND.OBJECT_KIND_SURFACE and item.height_m <= _CLOTH_M)


def attach(scene: Scene, poses: Poses, require_caller: Callable[[], None]) -> Poses:
    """The poses with every None filled in, hosts before their guests."""
    poses = list(poses)
    for i in sorted(range(len(poses)), key=lambda i: len(scene.hosts(i))):
        if poses[i] is None:
            require_caller()
            poses[i] = _best(scene, poses, i)
    return poses


def _best(scene: Scene, poses: Poses, i: int) -> Pose:
    item, home = scene.objects[i], _home(scene, poses, i)
    others = [rectangle(poses[k], other.width_m, other.depth_m) for k, other in enumerate(scene.objects)
              if k != i and poses[k] is not None and collide(scene, i, k)]
    boxes = [bounds(outline) for outline in others]

    def cost(pose: Pose) -> float:
        outline = rectangle(pose, item.width_m, item.depth_m)
        box = bounds(outline)
        wrong_m2 = area_m2(outline) - common_m2(scene.floor, outline)
        wrong_m2 += sum(common_m2(other, outline) for other, at in zip(others, boxes) if not apart(at, box))
        if item.kind == _KIND.OBJECT_KIND_WALL:
            wrong_m2 += _off_wall_m2(scene, i, pose)
        return _OVERLAP_FACTOR * max(wrong_m2, 0.0) + math.dist(pose.centre, home.centre)

    return min(_candidates(scene, poses, i), key=cost)


def _home(scene: Scene, poses: Poses, i: int) -> Pose:
    """Where an object would rather be: at its host, else in the middle of the room.

    At the back of the host when it hangs on a wall, or when it shares the host with others.
    """
    host = scene.host(i)
    if host is not None:
        surfaces = [k for k in range(len(poses)) if scene.host(k) == host
                    and scene.objects[k].kind == _KIND.OBJECT_KIND_SURFACE]
        at_back = scene.objects[i].kind == _KIND.OBJECT_KIND_WALL or (i in surfaces and len(surfaces) > 1)
        behind_m = scene.objects[host].depth_m / 2 if at_back else 0.0
        return Pose(*poses[host].at(0, -behind_m), poses[host].heading_rad)
    x, y, far_x, far_y = bounds(scene.floor)
    return Pose((x + far_x) / 2, (y + far_y) / 2, 0.0)


def _candidates(scene: Scene, poses: Poses, i: int) -> Iterator[Pose]:
    item, home, host = scene.objects[i], _home(scene, poses, i), scene.host(i)
    x, y, far_x, far_y = bounds(scene.floor)
    if item.kind == _KIND.OBJECT_KIND_WALL:
        for wall in scene.walls:
            for step in range(max(int((wall.length_m - item.width_m) / _SPACING_M), 0) + 1):
                yield Pose(*wall.at(item.width_m / 2 + step * _SPACING_M, item.depth_m / 2), wall.heading_rad)
    elif item.kind == _KIND.OBJECT_KIND_SURFACE and host is not None:
        under = scene.objects[host]
        yield from _grid(poses[host], under.width_m - item.width_m, under.depth_m - item.depth_m)
    elif item.kind == _KIND.OBJECT_KIND_CEILING:
        yield home
        middle = Pose((x + far_x) / 2, (y + far_y) / 2, 0.0)
        yield from _grid(middle, far_x - x - item.width_m, far_y - y - item.depth_m)
    else:
        across = abs(math.sin(home.heading_rad)) > 0.5
        half_x, half_y = (item.depth_m / 2, item.width_m / 2) if across else (item.width_m / 2, item.depth_m / 2)
        yield Pose(min(max(home.x_m, x + half_x), far_x - half_x), min(max(home.y_m, y + half_y), far_y - half_y),
                   home.heading_rad)


def _grid(middle: Pose, width_m: float, depth_m: float) -> Iterator[Pose]:
    """Poses all over a rectangle."""
    for column in range(_GRID):
        for row in range(_GRID):
            right, front = column / (_GRID - 1) - 0.5, row / (_GRID - 1) - 0.5
            yield Pose(*middle.at(right * max(width_m, 0.0), front * max(depth_m, 0.0)), middle.heading_rad)


def _off_wall_m2(scene: Scene, i: int, pose: Pose) -> float:
    """What of a wall object covers doors and windows; all of it when its back is on no wall."""
    item, back = scene.objects[i], pose.at(0, -scene.objects[i].depth_m / 2)
    for wall in scene.walls:
        x, y = back[0] - wall.start[0], back[1] - wall.start[1]
        if wall.heading_rad != pose.heading_rad or abs(x * wall.inward[0] + y * wall.inward[1]) > _TOUCH_M:
            continue
        along, covered = x * wall.along[0] + y * wall.along[1], 0.0
        for opening in scene.graph.room.openings:
            there, start, end = scene.opening_on_wall(opening)
            width = min(along + item.width_m / 2, end) - max(along - item.width_m / 2, start)
            top, bottom = item.elevation_m + item.height_m, item.elevation_m
            height = min(top, opening.head_height_m) - max(bottom, opening.sill_height_m)
            if there is wall and width > 0 and height > 0:
                covered += width * height
        return covered
    return item.width_m * item.height_m
