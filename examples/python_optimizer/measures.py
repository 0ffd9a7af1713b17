# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of a furnished room, as LayoutMetrics defines them, and where a person gets to, on a coarse grid."""

import math

from flair import v1

from attaching import collide
from functions import Poses
from geometry import Polygon, area_m2, bounds, common_m2, depth_m, rectangle
from scene import Scene

PERSON_RADIUS_M = 0.3
_CELL_M = 0.1
# Cells along the longer side of a large room.
_MOST_CELLS = 120

Cell = tuple[int, int]


def measure(scene: Scene, poses: Poses) -> v1.LayoutMetrics:
    """All but pathway_cost_m3, which needs the middle lines of all ways. Objects without a pose are not measured."""
    placed = {i: rectangle(pose, scene.objects[i].width_m, scene.objects[i].depth_m)
              for i, pose in enumerate(poses) if pose is not None}
    solid = {i: outline for i, outline in placed.items() if scene.stands(i)}
    outside = sum(area_m2(outline) - common_m2(scene.floor, outline) for outline in placed.values())
    pairs = [(i, k) for i in placed for k in placed if i < k and collide(scene, i, k)]
    overlap = sum(common_m2(placed[i], placed[k]) for i, k in pairs)
    overlap += sum(common_m2(outline, swing) for outline in solid.values() for swing in scene.swings)
    depths = [depth_m(placed[i], placed[k]) for i, k in pairs if i in solid and k in solid]
    depths += [depth_m(outline, swing) for outline in solid.values() for swing in scene.swings]
    depths += [_beyond_m(scene, corner) for outline in placed.values() for corner in outline]
    room = area_m2(scene.floor)
    floor_share, front_share = _reached(scene, poses, solid)
    return v1.LayoutMetrics(
        oob_percent=_percent(outside, room), oor_percent=_percent(overlap, room),
        deepest_overlap_m=max((depth for depth in depths if depth > 1e-6), default=0.0),
        reachable_floor_share=floor_share, reachable_front_share=front_share)


def _percent(part_m2: float, whole_m2: float) -> float:
    return 100 * part_m2 / whole_m2 if part_m2 > 1e-9 else 0.0  # less is rounding


def _inside(polygon: Polygon, x: float, y: float) -> bool:
    inside = False
    for i, (bx, by) in enumerate(polygon):
        ax, ay = polygon[i - 1]
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


def _beyond_m(scene: Scene, corner: tuple[float, float]) -> float:
    """How far a point is outside the floor."""
    if _inside(scene.floor, *corner):
        return 0.0
    return min(math.dist(corner, wall.at(min(max((corner[0] - wall.start[0]) * wall.along[0]
                                                 + (corner[1] - wall.start[1]) * wall.along[1], 0), wall.length_m), 0))
               for wall in scene.walls)


def _reached(scene: Scene, poses: Poses, solid: dict[int, Polygon]) -> tuple[float, float]:
    """Shares of the free floor and of the fronts of what stands there, for a person who comes in by a door."""
    _, _, far_x, far_y = bounds(scene.floor)
    cell_m = max(_CELL_M, max(far_x, far_y) / _MOST_CELLS)
    middles = {(c, r): ((c + 0.5) * cell_m, (r + 0.5) * cell_m)
               for c in range(math.ceil(far_x / cell_m)) for r in range(math.ceil(far_y / cell_m))}
    floor = {cell for cell, at in middles.items() if _inside(scene.floor, *at)}
    free = floor - {cell for outline in solid.values() for cell in _cells_in(outline, middles, cell_m)}
    radius = PERSON_RADIUS_M / cell_m
    near = [(c, r) for c in range(-math.ceil(radius), math.ceil(radius) + 1)
            for r in range(-math.ceil(radius), math.ceil(radius) + 1) if math.hypot(c, r) < radius]
    standing = {cell for cell in free if all((cell[0] + c, cell[1] + r) in free for c, r in near)}
    doors = [cell for area in scene.door_areas for cell in _cells_in(area, middles, cell_m) if cell in standing]
    reached = _flood(doors, standing)
    swept = {(cell[0] + c, cell[1] + r) for cell in reached for c, r in near} & free
    fronts = [any(cell in reached for cell in _cells_in(_before(scene, i, poses), middles, cell_m)) for i in solid]
    return (len(swept) / len(free) if free else 0.0, sum(fronts) / len(fronts) if fronts else 0.0)


def _before(scene: Scene, i: int, poses: Poses) -> Polygon:
    """Where a person stands who uses an object."""
    pose, item, deep_m = poses[i], scene.objects[i], 2 * PERSON_RADIUS_M
    half, front = item.width_m / 2, item.depth_m / 2
    return [pose.at(-half, front), pose.at(half, front), pose.at(half, front + deep_m), pose.at(-half, front + deep_m)]


def _cells_in(area: Polygon, middles: dict[Cell, tuple[float, float]], cell_m: float) -> list[Cell]:
    x, y, far_x, far_y = bounds(area)
    box = ((c, r) for c in range(int(x / cell_m), int(far_x / cell_m) + 1)
           for r in range(int(y / cell_m), int(far_y / cell_m) + 1))
    return [cell for cell in box if cell in middles and _inside(area, *middles[cell])]


def _flood(starts: list[Cell], standing: set[Cell]) -> set[Cell]:
    reached = set(starts)
    for c, r in (front := list(starts)):
        for cell in ((c + 1, r), (c - 1, r), (c, r + 1), (c, r - 1)):
            if cell in standing and cell not in reached:
                reached.add(cell)
                front.append(cell)
    return reached
