# SPDX-License-Identifier: GPL-3.0-or-later
"""against_wall: a side of an object, its back unless said otherwise, lies flush on a wall."""

import math
import random

from flair import v1

from examples_of import argument, placed_example, room_of
from functions import SIDES, Call, Function, Poses, Side, side_of
from geometry import Pose, heading_of
from scene import Scene, Wall


def cost_m2(scene: Scene, poses: Poses, call: Call) -> float:
    """min over walls of  gap^2 + overhang^2 + (1 - cos angle).

    gap: distance of the side's middle from the wall's line; overhang: of the side beyond the wall's ends; angle:
    between the side and the wall, counted as square metres.
    """
    i = call["object"]
    side = side_of(scene, i, poses[i], call["side"])
    return min(_cost_at(wall, side) for wall in _walls(scene, call))


def _walls(scene: Scene, call: Call) -> list[Wall]:
    return [call["wall"]] if call["wall"] is not None else scene.walls


def _cost_at(wall: Wall, side: Side) -> float:
    x, y = side.middle[0] - wall.start[0], side.middle[1] - wall.start[1]
    gap = x * wall.inward[0] + y * wall.inward[1]
    along = x * wall.along[0] + y * wall.along[1]
    overhang = max(side.half_m - along, along + side.half_m - wall.length_m, 0.0)
    cosine = -(side.outward[0] * wall.inward[0] + side.outward[1] * wall.inward[1])
    return gap * gap + overhang * overhang + max(1 - cosine, 0.0)


def propose(rng: random.Random, scene: Scene, poses: Poses, call: Call) -> Pose:
    """Flush on one of the walls, anywhere along it; half of the time in one of its corners."""
    i, walls = call["object"], _walls(scene, call)
    wall = walls[int(rng.random() * len(walls))]
    item, side = scene.objects[i], call["side"]
    upright = side in ("front", "back")
    half, reach = (item.width_m, item.depth_m) if upright else (item.depth_m, item.width_m)
    free = max(wall.length_m - half, 0.0)
    share = rng.random()
    if rng.random() < 0.5:
        share = 0.0 if share < 0.5 else 1.0
    outward = (-wall.inward[0], -wall.inward[1])
    heading = (heading_of(outward) - SIDES[side] * math.pi / 2) % math.tau
    return Pose(*wall.at(half / 2 + free * share, reach / 2), heading)


_ROOM = room_of(4, 3)
_DESK = {"desk": (1.2, 0.6)}

AGAINST_WALL = Function(
    type=v1.ConstraintType(
        name="against_wall",
        family="wall",
        summary="The given side of `object` (its back by default) lies flush on a wall.",
        doc="cost = min over walls of gap^2 + overhang^2 + (1 - cos angle) [m2].",
        parameters=[
            v1.ParameterSpec(name="object", kind=v1.ParameterKind.PARAMETER_KIND_OBJECT, required=True,
                             doc="What stands at the wall."),
            v1.ParameterSpec(name="side", kind=v1.ParameterKind.PARAMETER_KIND_SIDE,
                             doc="Its side that touches the wall.", default_value=v1.ArgumentValue(text="back")),
            v1.ParameterSpec(name="wall", kind=v1.ParameterKind.PARAMETER_KIND_WALL,
                             doc="The wall; any wall when left out."),
        ],
        examples=[
            v1.CallExample(sentence="The bed's headboard is against a wall.", arguments=[argument("object", "bed")]),
            v1.CallExample(sentence="The desk's left side touches the north wall.",
                           arguments=[argument("object", "desk"), argument("side", "left"), argument("wall", "north")]),
        ],
        placed_examples=[
            placed_example(_ROOM, _DESK, {"desk": (2, 0.3, 0)}, {"object": "desk"}, satisfied=True),
            placed_example(_ROOM, _DESK, {"desk": (0.6, 2.7, math.pi)}, {"object": "desk", "wall": "north"},
                           satisfied=True),
            placed_example(_ROOM, _DESK, {"desk": (2, 0.8, 0)}, {"object": "desk"}, satisfied=False),
            placed_example(_ROOM, _DESK, {"desk": (2, 0.3, 0)}, {"object": "desk", "side": "left"}, satisfied=False),
        ],
    ),
    cost=cost_m2,
    propose=propose,
)
