# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole solves of a small bedroom."""

import math
import unittest

from google.protobuf import text_format

from flair import v1
from flair.stage import problems_in

from examples_of import argument, room_of
from main import FUNCTIONS
from measures import measure
from problem import Problem
from solving import solve

DOOR = """id: "door_1" kind: OPENING_KIND_DOOR wall: "south" offset_m: 0.5 width_m: 0.9 head_height_m: 2
          leaf { hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5707963267948966 }"""
FLOOR, SURFACE, WALL = (getattr(v1.ObjectKind, f"OBJECT_KIND_{kind}") for kind in ("FLOOR", "SURFACE", "WALL"))


def thing(name: str, width_m: float, depth_m: float, kind: int = FLOOR, **more: object) -> v1.Object:
    role = v1.ObjectRole.OBJECT_ROLE_SECONDARY if kind == FLOOR else v1.ObjectRole.OBJECT_ROLE_TERTIARY
    return v1.Object(id=name, name=name, role=role, kind=kind, zone_id="sleeping", width_m=width_m, depth_m=depth_m,
                     height_m=0.5, **more)


def edge(name: str, kind: str, **arguments: str) -> v1.ConstraintEdge:
    return v1.ConstraintEdge(id=name, type=kind, weight=1, arguments=[argument(*pair) for pair in arguments.items()])


def bedroom() -> v1.LayoutGraph:
    graph = v1.LayoutGraph(room=room_of(4, 3), zone_plan=v1.ZonePlan(zones=[v1.Zone(id="sleeping", name="sleeping")]))
    graph.room.openings.append(text_format.Parse(DOOR, v1.Opening()))
    graph.object_list.objects.extend([
        thing("bed", 1.6, 2), thing("nightstand", 0.5, 0.4), thing("wardrobe", 1.2, 0.6),
        thing("lamp", 0.2, 0.2, SURFACE, host_id="nightstand"),
        thing("picture", 0.8, 0.05, WALL, host_id="bed", elevation_m=1.4),
    ])
    graph.edges.extend([
        edge("e1", "against_wall", object="bed", side="back"), edge("e2", "against_wall", object="wardrobe"),
        edge("e3", "next_to", object="nightstand", target="bed", target_side="right"),
    ])
    return graph


def solved(graph: v1.LayoutGraph, options: v1.SolveOptions | None = None) -> v1.SolvedLayout:
    options = options or v1.SolveOptions(seed=5, max_restart_count=1)
    return solve(Problem(graph, options, FUNCTIONS), options, lambda: None).solved_layout


def codes(layout: v1.SolvedLayout) -> set[str]:
    return {item.code for item in layout.diagnostics}


class Solving(unittest.TestCase):
    def test_everything_stands_well_for_any_seed(self) -> None:
        for seed in range(2):
            layout = solved(bedroom(), v1.SolveOptions(seed=seed))
            with self.subTest(seed=seed, layout=str(layout.diagnostics)):
                self.assertEqual(problems_in(layout), [])
                self.assertEqual(len(layout.placements), 5)
                self.assertNotIn("does_not_fit", codes(layout))
                self.assertEqual({outcome.status for outcome in layout.edge_outcomes},
                                 {v1.OutcomeStatus.OUTCOME_STATUS_SATISFIED})
                self.assertEqual((layout.metrics.oob_percent, layout.metrics.oor_percent), (0, 0))

    def test_a_seed_gives_one_layout_and_another_seed_another(self) -> None:
        first, again, other = (
            solved(bedroom(), v1.SolveOptions(seed=seed, max_restart_count=1)) for seed in (1, 1, 2))
        self.assertEqual(first.SerializeToString(deterministic=True), again.SerializeToString(deterministic=True))
        self.assertNotEqual(first.placements, other.placements)

    def test_what_is_pinned_stays(self) -> None:
        graph = bedroom()
        pin = v1.Placement(object_id="wardrobe", x_m=2.25, y_m=1.5, theta_rad=0.75)
        graph.pinned_placements.append(pin)
        self.assertEqual(solved(graph).placements[2], pin)

    def test_what_lies_and_hangs_has_its_place_and_height(self) -> None:
        layout = solved(bedroom())
        at = {place.object_id: place for place in layout.placements}
        self.assertEqual(at["lamp"].z_m, 0.5)
        self.assertLess(math.dist((at["lamp"].x_m, at["lamp"].y_m), (at["nightstand"].x_m, at["nightstand"].y_m)), 0.3)
        self.assertEqual(at["picture"].z_m, 1.4)
        reach_m = 0.05 / 2
        gaps = (at["picture"].x_m, 4 - at["picture"].x_m, at["picture"].y_m, 3 - at["picture"].y_m)
        self.assertAlmostEqual(min(gaps), reach_m)

    def test_furniture_that_does_not_fit_is_placed_and_named(self) -> None:
        graph = bedroom()
        graph.object_list.objects.extend([thing("table", 3, 2), thing("sofa", 3, 1.2)])
        layout = solved(graph)
        self.assertEqual(len(layout.placements), 7)
        self.assertIn("does_not_fit", codes(layout))

    def test_what_is_not_done_as_asked_is_said(self) -> None:
        graph = bedroom()
        graph.edges.append(edge("e4", "levitating", object="bed"))
        layout = solved(graph, v1.SolveOptions(max_restart_count=1, variant_count=3, find_contradictions=True))
        self.assertEqual(layout.edge_outcomes[3].status, v1.OutcomeStatus.OUTCOME_STATUS_DROPPED)
        self.assertIn('no constraint "levitating"', layout.edge_outcomes[3].reason)
        self.assertLessEqual({"not_taken", "option_ignored", "placed_by_rule", "not_measured"}, codes(layout))


class Ending(unittest.TestCase):
    def test_a_caller_that_left_ends_the_search(self) -> None:
        class Left(Exception):
            pass

        looks = []

        def require_caller() -> None:
            looks.append(1)
            if len(looks) > 3:
                raise Left

        options = v1.SolveOptions(max_restart_count=10000)
        with self.assertRaises(Left):
            solve(Problem(bedroom(), options, FUNCTIONS), options, require_caller)

    def test_a_time_limit_gives_the_best_so_far_and_says_so(self) -> None:
        options = v1.SolveOptions(max_restart_count=10000)
        options.time_limit.FromMicroseconds(1)
        layout = solved(bedroom(), options)
        self.assertEqual(len(layout.placements), 5)
        self.assertTrue(layout.stage_outcomes[0].stopped_early)
        self.assertIn("time_limit", codes(layout))


class Measuring(unittest.TestCase):
    def test_areas_outside_and_in_each_other_are_exact(self) -> None:
        problem = Problem(bedroom(), v1.SolveOptions(), FUNCTIONS)
        bed = v1.Placement(object_id="bed", x_m=2, y_m=2.5)
        metrics = measure(problem.scene, problem.poses([bed]))
        self.assertAlmostEqual(metrics.oob_percent, 100 * 1.6 * 0.5 / 12, 9)
        self.assertAlmostEqual(metrics.deepest_overlap_m, 0.5, 9)
        both = [bed, v1.Placement(object_id="wardrobe", x_m=2, y_m=1.5)]
        metrics = measure(problem.scene, problem.poses(both))
        self.assertAlmostEqual(metrics.oor_percent, 100 * 1.2 * 0.3 / 12, 9)

    def test_nobody_reaches_what_a_wardrobe_bars(self) -> None:
        graph = bedroom()
        del graph.object_list.objects[3:]
        graph.object_list.objects[2].width_m = 4
        problem = Problem(graph, v1.SolveOptions(), FUNCTIONS)
        barred = measure(problem.scene, problem.poses([v1.Placement(object_id="wardrobe", x_m=2, y_m=1.5)]))
        self.assertAlmostEqual(barred.reachable_floor_share, 0.5, 1)
        empty = measure(problem.scene, problem.poses([]))
        self.assertGreater(empty.reachable_floor_share, 0.95)


if __name__ == "__main__":
    unittest.main()
