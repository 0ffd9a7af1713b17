# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages that a stage must refuse, each with the field and the value that are wrong."""

import math
import unittest

import grpc
from google.protobuf import text_format

from flair import v1
from flair.stage import Refusal, problems_in, require

GRAPH = """
room {
  room_type: "bedroom"  height_m: 3
  floor { vertices {} vertices { x_m: 4 } vertices { x_m: 4 y_m: 5 } vertices { y_m: 5 } }
  walls { name: "south" } walls { name: "east" } walls { name: "north" } walls { name: "west" }
  openings { id: "door_1" kind: OPENING_KIND_DOOR wall: "south" offset_m: 0.5 width_m: 0.9 head_height_m: 2
             leaf { hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5 } }
}
zone_plan { zones { id: "sleeping" name: "sleeping" } }
object_list {
  objects { id: "bed" name: "bed" role: OBJECT_ROLE_PRIMARY kind: OBJECT_KIND_FLOOR zone_id: "sleeping"
            width_m: 1.6 depth_m: 2 height_m: 0.5 }
  objects { id: "lamp" name: "lamp" role: OBJECT_ROLE_TERTIARY kind: OBJECT_KIND_SURFACE host_id: "bed"
            width_m: 0.2 depth_m: 0.2 height_m: 0.4 }
}
constraint_list { sentences { id: "s1" text: "A sentence." scope: SENTENCE_SCOPE_INTRA subject_ids: "bed" weight: 1 } }
edges { id: "e1" type: "against_wall" weight: 1 sentence_id: "s1" }
"""

# A change in text form, merged into the graph, and what must be said of it.
FAULTS = {
    "a width below zero": (
        "object_list { objects { width_m: -1 } }", "object_list.objects[2].width_m: -1 is outside (0, 20]"),
    "a number that is none": ("room { height_m: nan }", "room.height_m: nan is not a number"),
    "a room that is too high": ("room { height_m: 40 }", "room.height_m: 40 is outside [2, 12]"),
    "an id twice": (
        'zone_plan { zones { id: "sleeping" name: "x" } }', 'zone_plan.zones[1].id: "sleeping" is there twice'),
    "an id with a space": ('edges { id: "e 2" }', 'edges[1].id: "e 2" is not an id'),
    "an enum that is left out": ('room { openings { id: "w" } }', "room.openings[1].kind: is not set"),
    "an enum of no known value": (
        "object_list { objects { role: 77 } }", "object_list.objects[2].role: 77 is not a known value"),
    "a wall that is not there": (
        'room { openings { id: "w" wall: "up" } }', 'room.openings[1].wall: "up" is not a wall'),
    "an opening beyond its wall": (
        'room { openings { id: "w" wall: "south" offset_m: 3 width_m: 2 } }',
        'room.openings[1].width_m: 2 does not fit wall "south" (4 m from 3 m); at most 1'),
    "one wall too many": ('room { walls { name: "up" } }', "room.walls: has 5 walls for a floor of 4 edges"),
    "a floor that does not begin at 0": (
        "room { floor { vertices { x_m: -9 y_m: 9 } } }", "room.floor: x_m is in [-9, 4]"),
    "a zone that is not there": (
        'object_list { objects { id: "x" zone_id: "y" } }', 'objects[2].zone_id: "y" is not a zone'),
    "a primary on the wall": (
        "object_list { objects { role: OBJECT_ROLE_PRIMARY kind: OBJECT_KIND_WALL } }", "objects[2].kind: primaries"),
    "an object on itself": (
        'object_list { objects { id: "x" host_id: "x" } }', 'objects[2].host_id: "x" is not another'),
    "a sentence about nobody": (
        'constraint_list { sentences { id: "s2" subject_ids: "ghost" } }', 'subject_ids[0]: "ghost" is not an object'),
    "an edge of no sentence": (
        'edges { id: "e2" sentence_id: "s9" }', 'edges[1].sentence_id: "s9" is not a sentence'),
    "a pin far outside": (
        'pinned_placements { object_id: "bed" x_m: 9 }', "pinned_placements[0].x_m: 9 is outside [-1.0, 5]"),
    "a pin of nothing": ('pinned_placements { object_id: "ghost" }', 'pinned_placements[0].object_id: "ghost"'),
}


def graph(change: str = "") -> v1.LayoutGraph:
    return text_format.Merge(change, text_format.Parse(GRAPH, v1.LayoutGraph()))


class Checks(unittest.TestCase):
    def test_a_good_graph_has_no_problems(self) -> None:
        self.assertEqual(problems_in(graph()), [])

    def test_every_fault_is_named_with_its_field_and_value(self) -> None:
        for name, (change, problem) in FAULTS.items():
            with self.subTest(name):
                found = problems_in(graph(change))
                self.assertTrue(any(problem in line for line in found), found)

    def test_a_floor_that_runs_clockwise_is_refused(self) -> None:
        clockwise = graph()
        corners = [(p.x_m, p.y_m) for p in clockwise.room.floor.vertices]
        for vertex, (x, y) in zip(clockwise.room.floor.vertices, reversed(corners)):
            vertex.x_m, vertex.y_m = x, y
        self.assertIn("room.floor: runs clockwise; must be counter-clockwise", problems_in(clockwise))

    def test_a_floor_that_crosses_itself_is_refused(self) -> None:
        crossed = graph()
        crossed.room.floor.vertices[1].x_m, crossed.room.floor.vertices[2].x_m = 0, 4
        crossed.room.floor.vertices[3].x_m, crossed.room.floor.vertices[3].y_m = 4, 0
        self.assertTrue(any("room.floor: is not simple" in line for line in problems_in(crossed)), problems_in(crossed))

    def test_a_floor_with_two_edges_on_one_line_is_good(self) -> None:
        corners = [(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 4), (0, 4)]  # a U
        room = graph().room
        del room.floor.vertices[:], room.walls[4:], room.openings[:]
        for x, y in corners:
            room.floor.vertices.add(x_m=x, y_m=y)
        room.walls.extend([v1.Wall(name=f"wall_{index}") for index in range(4, 8)])
        self.assertEqual(problems_in(room), [])

    def test_placements_to_evaluate_are_those_of_objects(self) -> None:
        request = v1.EvaluateRequest(layout_graph=graph(), placements=[v1.Placement(object_id="ghost")])
        self.assertEqual(problems_in(request), ['placements[0].object_id: "ghost" is not an object of this message'])

    def test_a_time_limit_of_nothing_is_refused(self) -> None:
        request = v1.SolveRequest(layout_graph=graph())
        request.options.time_limit.FromSeconds(0)
        self.assertEqual(problems_in(request), ["options.time_limit: 0s is not a duration; more than 0 s"])

    def test_paths_begin_with_the_fields_of_the_request(self) -> None:
        request = v1.SolveRequest(layout_graph=graph())
        request.layout_graph.object_list.objects[0].depth_m = math.inf
        request.options.seed = -1
        found = problems_in(request)
        self.assertEqual(found, ["layout_graph.object_list.objects[0].depth_m: inf is not a number",
                                 "options.seed: -1 is outside [0, 9007199254740992)"])

    def test_a_brief_without_text_is_refused_by_the_name_of_its_field(self) -> None:
        for request in (v1.DescribeRoomRequest(), v1.DescribeRoomRequest(brief=v1.Brief(text=" \n"))):
            with self.assertRaises(Refusal) as caught:
                require(request, "brief")
            self.assertEqual(caught.exception.status, grpc.StatusCode.INVALID_ARGUMENT)
            self.assertEqual(caught.exception.message, "brief.text: is empty")

    def test_a_long_list_of_problems_is_cut(self) -> None:
        request = v1.SolveRequest(layout_graph=graph("object_list { objects {} objects {} objects {} }"))
        with self.assertRaises(Refusal) as caught:
            require(request, "layout_graph")
        self.assertIn(" more)", caught.exception.message)


if __name__ == "__main__":
    unittest.main()
