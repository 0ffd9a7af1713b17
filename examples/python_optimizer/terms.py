# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole-room terms that the search adds by itself. All are areas [m2], or squared metres, and zero when met."""

from dataclasses import dataclass

from flair import v1

from functions import Bound
from geometry import Box, Polygon, Pose, apart, area_m2, bounds, common_m2, rectangle
from scene import Scene

# What a square metre of each costs, beside 1 for a call of weight 1.
FACTORS = {"doors_clear": 30.0, "fronts_free": 4.0, "in_bounds": 30.0, "no_overlap": 30.0, "together": 0.004}

SUMMARIES = {
    "doors_clear": "Nothing stands where a door opens or directly before it.",
    "fronts_free": "The floor before what has its back on a wall is free and in the room, as deep as a way is wide.",
    "in_bounds": "Everything stands within the room.",
    "no_overlap": "Nothing stands in anything else; rugs lie under things.",
    "together": "Squared distance of each object to the primary object of its zone: not met, but kept small.",
}

DEFAULT_PATH_WIDTH_M = 0.6


def built_in_types() -> list[v1.ConstraintType]:
    """For the catalogue: translators must not call these."""
    return [v1.ConstraintType(name=name, family="room", summary=summary, built_in=True,
                              doc=f"Counted {FACTORS[name]:g} times by the search.")
            for name, summary in SUMMARIES.items()]


@dataclass(frozen=True)
class Standing:
    """An object in its place: what it covers and the strip before it, with the boxes around them."""

    pose: Pose
    outline: Polygon
    box: Box
    strip: Polygon
    strip_box: Box


class Terms:
    """The terms of one scene, object by object and pair by pair, so that a search recomputes only what moved."""

    def __init__(self, scene: Scene, calls: list[Bound], path_width_m: float) -> None:
        self._scene = scene
        self._floor_box = bounds(scene.floor)
        self._path_width_m = path_width_m
        self._doors = [(area, bounds(area)) for area in scene.door_areas]
        self._related = {frozenset(call.objects) for call in calls if len(call.objects) == 2}
        self._has_front = {call.objects[0] for call in calls if call.call.get("side") == "back"}
        primary = v1.ObjectRole.OBJECT_ROLE_PRIMARY
        heads = {item.zone_id: i for i, item in reversed(list(enumerate(scene.objects))) if item.role == primary}
        self.head = {i: heads[item.zone_id] for i, item in enumerate(scene.objects)
                     if scene.stands(i) and heads.get(item.zone_id, i) != i}

    def place(self, i: int, pose: Pose) -> Standing:
        item = self._scene.objects[i]
        outline = rectangle(pose, item.width_m, item.depth_m)
        ahead = Pose(*pose.at(0, (item.depth_m + self._path_width_m) / 2), pose.heading_rad)
        strip = rectangle(ahead, item.width_m, self._path_width_m)
        return Standing(pose, outline, bounds(outline), strip, bounds(strip))

    def of_one(self, i: int, at: Standing) -> dict[str, float]:
        """What an object costs wherever the others are, without factors."""
        costs = {"in_bounds": self._outside_m2(at.outline)}
        costs["doors_clear"] = sum(common_m2(at.outline, door) for door, box in self._doors if not apart(box, at.box))
        if i in self._has_front:
            costs["fronts_free"] = self._outside_m2(at.strip)
        return costs

    def of_two(self, i: int, k: int, at: Standing, other: Standing) -> dict[str, float]:
        """What two objects cost where they are, without factors."""
        costs = {}
        if not apart(at.box, other.box):
            costs["no_overlap"] = common_m2(at.outline, other.outline)
        if frozenset((i, k)) not in self._related:
            if i in self._has_front and not apart(at.strip_box, other.box):
                costs["fronts_free"] = common_m2(at.strip, other.outline)
            if k in self._has_front and not apart(other.strip_box, at.box):
                costs["fronts_free"] = costs.get("fronts_free", 0.0) + common_m2(other.strip, at.outline)
        if self.head.get(i) == k or self.head.get(k) == i:
            dx, dy = at.pose.x_m - other.pose.x_m, at.pose.y_m - other.pose.y_m
            costs["together"] = dx * dx + dy * dy
        return costs

    def _outside_m2(self, outline: Polygon) -> float:
        missing = area_m2(outline) - common_m2(self._scene.floor, outline)
        return missing if missing > 1e-9 else 0.0  # less is rounding
