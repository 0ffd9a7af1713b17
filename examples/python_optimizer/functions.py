# SPDX-License-Identifier: GPL-3.0-or-later
"""What a constraint function is, and how the calls of a graph become something that can be computed.

To add one: a file like next_to.py that makes a Function, and its name in the list of main.py.
"""

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flair import v1

from geometry import Point, Pose
from scene import Scene

Poses = list[Pose | None]
# Arguments by name: the index of an object, a Wall, or a text; None where a call leaves one out that has no default.
Call = dict[str, Any]

# A call holds when its cost is at most this [m2].
SATISFIED_M2 = 1e-3

# Turn from an object's heading to the direction that each of its sides looks in, in quarters counter-clockwise.
SIDES = {"front": 0, "left": 1, "back": 2, "right": 3}


@dataclass(frozen=True)
class Function:
    """One type of constraint."""

    type: v1.ConstraintType
    """What the catalogue says of it."""
    cost: Callable[[Scene, Poses, Call], float]
    """[m2]; zero exactly where the sentence is true, never negative."""
    propose: Callable[[random.Random, Scene, Poses, Call], Pose]
    """A pose of the call's `object` for which the cost is zero, by chance one of many."""


@dataclass(frozen=True)
class Bound:
    """A call of a graph that can be computed."""

    edge_id: str
    function: Function
    call: Call
    weight: float
    objects: tuple[int, ...]
    """Those that its cost depends on; the first is the one that it moves."""

    def cost(self, scene: Scene, poses: Poses) -> float:
        return self.function.cost(scene, poses, self.call)


@dataclass(frozen=True)
class Side:
    """One side of an object."""

    middle: Point
    outward: Point
    half_m: float


def side_of(scene: Scene, i: int, pose: Pose, side: str) -> Side:
    width, depth = scene.objects[i].width_m, scene.objects[i].depth_m
    if side in ("front", "back"):
        sign = 1 if side == "front" else -1
        return Side(pose.at(0, sign * depth / 2), (sign * pose.front[0], sign * pose.front[1]), width / 2)
    sign = 1 if side == "right" else -1
    return Side(pose.at(sign * width / 2, 0), (sign * pose.right[0], sign * pose.right[1]), depth / 2)


def bind(edge: v1.ConstraintEdge, functions: dict[str, Function], scene: Scene) -> Bound | str:
    """The call, or the sentence that says why it cannot be taken."""
    function = functions.get(edge.type)
    if function is None:
        return f'this optimizer has no constraint "{edge.type}"; it has {", ".join(functions)}'
    given = {argument.name: argument.value for argument in edge.arguments}
    call: Call = {}
    for parameter in function.type.parameters:
        value = given.pop(parameter.name, parameter.default_value)
        text = value.text
        if not text:
            if parameter.required:
                return f"{edge.type} needs {parameter.name}"
            call[parameter.name] = None
            continue
        call[parameter.name] = _resolve(parameter.kind, text, scene)
        if call[parameter.name] is None:
            return f'{edge.type}.{parameter.name}: "{text}" is not in this room or does not stand on its floor'
    if given:
        return f"{edge.type} has no {', '.join(given)}; it has {', '.join(call)}"
    objects = tuple(call[name] for name in ("object", "target") if name in call)
    if len(set(objects)) < len(objects):
        return f"{edge.type}: nothing can be related to itself"
    return Bound(edge.id, function, call, edge.weight, objects)


def _resolve(kind: int, text: str, scene: Scene) -> Any:
    if kind == v1.ParameterKind.PARAMETER_KIND_OBJECT:
        index = scene.index.get(text)
        return index if index is not None and scene.stands(index) else None
    if kind == v1.ParameterKind.PARAMETER_KIND_WALL:
        return scene.wall(text)
    return text if text in SIDES else None
