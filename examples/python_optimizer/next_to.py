# SPDX-License-Identifier: GPL-3.0-or-later
"""next_to: a side of one object touches a side of another."""

import math
import random

from flair import v1

from examples_of import argument, placed_example, room_of
from functions import SIDES, Call, Function, Poses, Side, side_of
from geometry import Pose, heading_of
from scene import Scene

AIR_M = 0.05


def cost_m2(scene: Scene, poses: Poses, call: Call) -> float:
    """min over the allowed pairs of sides of  gap^2 + overhang^2 + (1 - cos angle).

    gap: of the object's side beyond [0, AIR_M] in front of the target's; overhang: of the shorter side beyond the
    longer; angle: away from looking at each other, counted as square metres.
    """
    i, k = call["object"], call["target"]
    least = math.inf
    for target_side in _allowed(call["target_side"]):
        target = side_of(scene, k, poses[k], target_side)
        for object_side in _allowed(call["object_side"]):
            least = min(least, _cost_between(side_of(scene, i, poses[i], object_side), target))
    return least


def _allowed(side: str | None) -> list[str]:
    return [side] if side is not None else list(SIDES)


def _cost_between(side: Side, target: Side) -> float:
    x, y = side.middle[0] - target.middle[0], side.middle[1] - target.middle[1]
    (nx, ny) = target.outward
    gap = x * nx + y * ny
    beyond = max(-gap, gap - AIR_M, 0.0)
    overhang = max(abs(x * ny - y * nx) - abs(side.half_m - target.half_m), 0.0)
    cosine = -(side.outward[0] * nx + side.outward[1] * ny)
    return beyond * beyond + overhang * overhang + max(1 - cosine, 0.0)


def propose(rng: random.Random, scene: Scene, poses: Poses, call: Call) -> Pose:
    """In touch, flush with one end of the target's side, in its middle, or anywhere along it."""
    i, k = call["object"], call["target"]
    target_sides, object_sides = _allowed(call["target_side"]), _allowed(call["object_side"])
    target = side_of(scene, k, poses[k], target_sides[int(rng.random() * len(target_sides))])
    side = object_sides[int(rng.random() * len(object_sides))]
    item = scene.objects[i]
    length, reach = (item.width_m, item.depth_m) if side in ("front", "back") else (item.depth_m, item.width_m)
    slack = abs(length / 2 - target.half_m)
    along = slack * (-1.0, 0.0, 1.0, 2 * rng.random() - 1)[int(rng.random() * 4)]
    (nx, ny) = target.outward
    heading = (heading_of((-nx, -ny)) - SIDES[side] * math.pi / 2) % math.tau
    return Pose(target.middle[0] + nx * reach / 2 - ny * along, target.middle[1] + ny * reach / 2 + nx * along, heading)


_ROOM = room_of(4, 3)
_PIECES = {"bed": (1.6, 2.0), "nightstand": (0.5, 0.4)}
_BED = {"bed": (2, 1, 0)}
_PAIR = {"object": "nightstand", "target": "bed"}


def _side(name: str, doc: str) -> v1.ParameterSpec:
    return v1.ParameterSpec(name=name, kind=v1.ParameterKind.PARAMETER_KIND_SIDE, doc=doc)


NEXT_TO = Function(
    type=v1.ConstraintType(
        name="next_to",
        family="pair",
        summary="A side of `object` touches a side of `target` (up to 5 cm of air), the shorter within the longer.",
        doc="cost = min over allowed pairs of sides of gap^2 + overhang^2 + (1 - cos angle) [m2].",
        parameters=[
            v1.ParameterSpec(name="object", kind=v1.ParameterKind.PARAMETER_KIND_OBJECT, required=True,
                             doc="What is put there."),
            v1.ParameterSpec(name="target", kind=v1.ParameterKind.PARAMETER_KIND_OBJECT, required=True,
                             doc="What it stands at."),
            _side("object_side", "Its side that touches; any when left out."),
            _side("target_side", "The target's side that is touched; any when left out."),
        ],
        examples=[
            v1.CallExample(sentence="The nightstand is next to the bed.",
                           arguments=[argument(*pair) for pair in _PAIR.items()]),
            v1.CallExample(sentence="The chair is pushed up to the front of the desk.",
                           arguments=[argument("object", "chair"), argument("target", "desk"),
                                      argument("object_side", "front"), argument("target_side", "front")]),
        ],
        placed_examples=[
            placed_example(_ROOM, _PIECES, {**_BED, "nightstand": (3.07, 0.2, 0)}, _PAIR, satisfied=True),
            placed_example(_ROOM, _PIECES, {**_BED, "nightstand": (3.07, 0.2, 0)}, {**_PAIR, "target_side": "right"},
                           satisfied=True),
            placed_example(_ROOM, _PIECES, {**_BED, "nightstand": (3.5, 0.2, 0)}, _PAIR, satisfied=False),
            placed_example(_ROOM, _PIECES, {**_BED, "nightstand": (3.07, 0.2, 0)}, {**_PAIR, "target_side": "left"},
                           satisfied=False),
        ],
    ),
    cost=cost_m2,
    propose=propose,
)
