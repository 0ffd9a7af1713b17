# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated annealing over the poses of what stands on the floor.

cost = sum of factor * term over objects and pairs + sum of weight * cost over calls, see terms.py and functions.py.
Draws only from random(), the one method of Python's generator whose numbers are the same in every version.
"""

import math
import random
from collections.abc import Callable, Collection
from dataclasses import dataclass

from functions import Bound, Poses
from geometry import Pose, bounds
from scene import Scene
from terms import FACTORS, Standing, Terms

STEPS_PER_OBJECT = 400
MOST_STEPS = 12000
HOT, COLD = 3.0, 1e-5


@dataclass(frozen=True)
class Outcome:
    """Where one restart ended."""

    cost: float
    poses: Poses
    step_count: int
    stopped: bool
    """Whether `out_of_time` ended it."""


class Annealing:
    """One restart. `movable` are the objects whose poses are sought; `poses` has those of all others on the floor."""

    def __init__(
        self, scene: Scene, terms: Terms, calls: list[Bound], poses: Poses, movable: list[int], seed: str
    ) -> None:
        self._scene, self._terms, self._movable = scene, terms, movable
        self._rng = random.Random(seed)
        self._box = bounds(scene.floor)
        self._standing = [i for i in range(len(poses)) if scene.stands(i)]
        self._calls_on = [[call for call in calls if i in call.objects] for i in range(len(poses))]
        self._moving = [[call for call in calls if call.objects[0] == i] for i in range(len(poses))]
        self._followers = [self._following(i, calls) for i in range(len(poses))]
        self._poses: Poses = [self._anywhere() if i in movable else pose for i, pose in enumerate(poses)]
        self._at: dict[int, Standing] = {i: terms.place(i, self._poses[i]) for i in self._standing}

    def run(self, out_of_time: Callable[[], bool]) -> Outcome:
        """The best poses seen. `out_of_time` is asked at every step; it may raise, to end the run without a result."""
        steps = min(STEPS_PER_OBJECT * len(self._movable), MOST_STEPS)
        cost = self._cost_of(self._movable)
        best, best_poses = cost, list(self._poses)
        for step in range(steps):
            if out_of_time():
                return Outcome(best, best_poses, step, True)
            heat = HOT * (COLD / HOT) ** (step / steps)
            moved = self._propose(heat)
            before, undo = self._cost_of(moved), {i: (self._poses[i], self._at[i]) for i in moved}
            for i, pose in moved.items():
                self._poses[i], self._at[i] = pose, self._terms.place(i, pose)
            gain = before - self._cost_of(moved)
            if gain < 0 and self._rng.random() >= math.exp(gain / heat):
                for i, (pose, at) in undo.items():
                    self._poses[i], self._at[i] = pose, at
                continue
            cost -= gain
            if cost < best - 1e-12:
                best, best_poses = cost, list(self._poses)
        return Outcome(best, best_poses, steps, False)

    def _cost_of(self, moved: Collection[int]) -> float:
        """All terms and calls that depend on the pose of one of `moved`."""
        cost = 0.0
        for i in moved:
            costs = [self._terms.of_one(i, self._at[i])]
            costs += [self._terms.of_two(i, k, self._at[i], self._at[k])
                      for k in self._standing if k != i and (k > i or k not in moved)]
            cost += sum(FACTORS[term] * value for part in costs for term, value in part.items())
        calls = {call.edge_id: call for i in moved for call in self._calls_on[i]}
        return cost + sum(call.weight * call.cost(self._scene, self._poses) for call in calls.values())

    def _propose(self, heat: float) -> dict[int, Pose]:
        """New poses of the objects that one step moves."""
        rng = self._rng
        i = self._movable[int(rng.random() * len(self._movable))]
        kind, old = rng.random(), self._poses[i]
        if kind < 0.45 and self._moving[i]:
            call = self._moving[i][int(rng.random() * len(self._moving[i]))]
            new = call.function.propose(rng, self._scene, self._poses, call.call)
        elif kind < 0.8:
            reach_m = 0.02 + 0.3 * math.sqrt(heat)
            dx_m, dy_m = reach_m * (2 * rng.random() - 1), reach_m * (2 * rng.random() - 1)
            new = Pose(old.x_m + dx_m, old.y_m + dy_m, old.heading_rad)
        elif kind < 0.9:
            new = Pose(old.x_m, old.y_m, self._anywhere().heading_rad)
        elif kind < 0.95:
            new = self._anywhere()
        else:
            k = self._movable[int(rng.random() * len(self._movable))]
            return {i: self._poses[k], k: old}
        moved = {i: new}
        if rng.random() < 0.7:
            moved |= {k: _carried(self._poses[k], old, new) for k in self._followers[i]}
        return moved

    def _anywhere(self) -> Pose:
        """A place in the box around the floor, along one of the walls."""
        rng, (x, y, far_x, far_y) = self._rng, self._box
        wall = self._scene.walls[int(rng.random() * len(self._scene.walls))]
        return Pose(x + rng.random() * (far_x - x), y + rng.random() * (far_y - y), wall.heading_rad)

    def _following(self, i: int, calls: list[Bound]) -> list[int]:
        """What is to stand at object i, at what stands at it, and so on."""
        found = [i]
        for leader in found:
            found += [call.objects[0] for call in calls if call.objects[1:] == (leader,)
                      and call.objects[0] not in found and call.objects[0] in self._movable]
        return found[1:]


def _carried(follower: Pose, old: Pose, new: Pose) -> Pose:
    """A pose that keeps its place before `old` when that becomes `new`."""
    dx, dy = follower.x_m - old.x_m, follower.y_m - old.y_m
    right_m, front_m = dx * old.right[0] + dy * old.right[1], dx * old.front[0] + dy * old.front[1]
    return Pose(*new.at(right_m, front_m), (follower.heading_rad + new.heading_rad - old.heading_rad) % math.tau)
