# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for every function of the catalogue, and what only one of them knows."""

import math
import random
import unittest

from flair import v1

from examples_of import argument
from functions import SATISFIED_M2, Bound, bind
from geometry import Pose
from main import FUNCTIONS
from problem import Problem
from scene import Scene


def graph_of(example: v1.PlacedExample, name: str) -> v1.LayoutGraph:
    edge = v1.ConstraintEdge(id="e1", type=name, weight=1, arguments=example.arguments)
    return v1.LayoutGraph(room=example.room, zone_plan=example.zone_plan, object_list=example.object_list, edges=[edge])


def cases() -> list[tuple[str, v1.PlacedExample, Problem]]:
    found = []
    for name, function in FUNCTIONS.items():
        for example in function.type.placed_examples:
            found.append((name, example, Problem(graph_of(example, name), v1.SolveOptions(), FUNCTIONS)))
    return found


class EveryFunction(unittest.TestCase):
    def test_its_examples_have_their_verdict(self) -> None:
        for name, example, problem in cases():
            with self.subTest(name, arguments=str(example.arguments)):
                outcome, = problem.edge_outcomes(problem.poses(example.placements))
                wanted = "SATISFIED" if example.satisfied else "VIOLATED"
                self.assertEqual(v1.OutcomeStatus.Name(outcome.status), f"OUTCOME_STATUS_{wanted}", outcome)

    def test_what_it_proposes_costs_nothing(self) -> None:
        rng = random.Random(7)
        for name, example, problem in cases():
            call = problem.calls["e1"]
            poses = problem.poses(example.placements)
            for _ in range(200):
                poses[call.objects[0]] = call.function.propose(rng, problem.scene, poses, call.call)
                self.assertLess(call.cost(problem.scene, poses), 1e-12, (name, poses))

    def test_a_full_turn_changes_nothing(self) -> None:
        for name, example, problem in cases():
            poses = problem.poses(example.placements)
            turned = [Pose(pose.x_m, pose.y_m, pose.heading_rad + math.tau) for pose in poses]
            call = problem.calls["e1"]
            self.assertAlmostEqual(call.cost(problem.scene, poses), call.cost(problem.scene, turned), 9, name)


class Binding(unittest.TestCase):
    def reason(self, kind: str, **arguments: str) -> str:
        scene = Scene(graph_of(FUNCTIONS["next_to"].type.placed_examples[0], "next_to"))
        given = [argument(*pair) for pair in arguments.items()]
        edge = v1.ConstraintEdge(id="e1", type=kind, weight=1, arguments=given)
        bound = bind(edge, FUNCTIONS, scene)
        self.assertNotIsInstance(bound, Bound)
        return bound

    def test_what_cannot_be_taken_says_why(self) -> None:
        self.assertIn("it has against_wall, next_to", self.reason("between", object="bed"))
        self.assertEqual(self.reason("next_to", object="bed"), "next_to needs target")
        self.assertIn('next_to.target: "ghost"', self.reason("next_to", object="bed", target="ghost"))
        self.assertIn('against_wall.side: "top"', self.reason("against_wall", object="bed", side="top"))
        self.assertIn('against_wall.wall: "up"', self.reason("against_wall", object="bed", wall="up"))
        self.assertIn("against_wall has no angle", self.reason("against_wall", object="bed", angle="x"))
        self.assertIn("itself", self.reason("next_to", object="bed", target="bed"))


class AgainstWall(unittest.TestCase):
    def test_the_cost_grows_with_the_square_of_the_gap(self) -> None:
        name, example, problem = cases()[0]
        call, width_m = problem.calls["e1"], 0.6
        for gap_m in (0.0, 0.1, 0.5):
            cost = call.cost(problem.scene, [Pose(2, width_m / 2 + gap_m, 0)])
            self.assertAlmostEqual(cost, gap_m**2, 12, name)


class NextTo(unittest.TestCase):
    def test_five_centimetres_of_air_are_none(self) -> None:
        example = FUNCTIONS["next_to"].type.placed_examples[0]
        problem = Problem(graph_of(example, "next_to"), v1.SolveOptions(), FUNCTIONS)
        bed = Pose(2, 1, 0)
        for gap_m, holds in ((0.0, True), (0.05, True), (0.2, False), (-0.2, False)):
            cost = problem.calls["e1"].cost(problem.scene, [bed, Pose(2.8 + 0.25 + gap_m, 1, 0)])
            self.assertEqual(cost <= SATISFIED_M2, holds, gap_m)


if __name__ == "__main__":
    unittest.main()
