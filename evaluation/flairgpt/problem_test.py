# SPDX-License-Identifier: GPL-3.0-or-later
"""testdata/small_study.json is written for these tests, in the format and with the habits of the recorded problems."""

import copy
import json
import math
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

from calls import FUNCTIONS, canonical  # noqa: E402
from problem import BadProblem, judge_layout, read_graph, read_placements  # noqa: E402

TEXT = (HERE / "testdata/small_study.json").read_text(encoding="utf-8")


def study_with(pointer: str, value: object) -> str:
    """The study with one value changed, as text."""
    study = json.loads(TEXT)
    at, *names = [int(name) if name.isdigit() else name for name in reversed(pointer.split("/")[1:])]
    inside = study
    for name in reversed(names):
        inside = inside[name]
    inside[at] = value
    return json.dumps(study)


class Graphs(unittest.TestCase):
    def setUp(self) -> None:
        self.graph = read_graph(TEXT)

    def arguments(self, kind: str, skip: int = 0) -> dict:
        """Of an edge of that type, as names and values."""
        edge = [edge for edge in self.graph["edges"] if edge["type"] == kind][skip]
        return {one["name"]: next(iter(one["value"].values())) for one in edge["arguments"]}

    def test_objects_and_zones(self) -> None:
        objects = self.graph["object_list"]["objects"]
        self.assertEqual((len(objects), len(self.graph["zone_plan"]["zones"])), (7, 2))
        self.assertTrue(next(made for made in objects if made["id"] == "item_0")["walk_over"])

    def test_positions_are_shares_of_what_the_opening_leaves_of_the_wall(self) -> None:
        door, north, west = self.graph["room"]["openings"]
        self.assertEqual((door["kind"], door["offset_m"]), ("OPENING_KIND_DOOR", 0))
        # West is walked from north to south: 0.5 of the 2.2 m left.
        self.assertEqual(west["wall"], "west")
        self.assertAlmostEqual(west["offset_m"], 1.1)
        self.assertAlmostEqual(self.graph["room"]["sockets"][0]["offset_m"], 0.5 * 2.9 + 0.05)
        # Windows that overlap become one: from 0.75 to 2.5 m from the west end, walked from the east.
        self.assertEqual((north["wall"], north["offset_m"], north["width_m"]), ("north", 1.5, 1.75))

    def test_calls_become_edges_under_our_names_without_repeats(self) -> None:
        self.assertEqual([edge["type"] for edge in self.graph["edges"]],
                         ["against_wall", "accessible", "facing", "in_zone", "not_against_wall", "near", "away_from",
                          "away_from", "parallel", "rug_under_center", "on_top_corner", "on_wall_above",
                          "ceiling_center"])

    def test_arguments_are_read_by_position_and_by_keyword(self) -> None:
        self.assertEqual(self.arguments("against_wall"), {"object": "floor_0", "side": "back"})
        self.assertEqual(self.arguments("facing"), {"object": "floor_1", "target": "floor_0", "both": True})
        self.assertEqual(self.arguments("rug_under_center"), {"rug": "item_0", "object": "floor_2"})
        self.assertEqual(self.arguments("on_top_corner"),
                         {"object": "item_1", "host": "floor_0", "corner": "back_right"})
        # A lone number after the object is a distance.
        self.assertEqual(self.arguments("accessible"), {"object": "floor_0", "min_clearance_m": 0.7})
        # A zone without the word "area".
        self.assertEqual(self.arguments("in_zone"), {"object": "floor_2", "zone": "reading_area"})

    def test_walls_and_furniture_in_place_of_features_are_read_as_what_they_are(self) -> None:
        self.assertEqual(self.arguments("not_against_wall"), {"object": "floor_2", "min_distance_m": 0.3})
        self.assertEqual(self.arguments("near"), {"object": "floor_2", "target": "floor_0", "max_distance_m": 1.5})

    def test_several_partners_are_several_edges(self) -> None:
        for skip, target in enumerate(("floor_0", "floor_1")):
            self.assertEqual(self.arguments("away_from", skip),
                             {"object": "floor_2", "target": target, "min_distance_m": 0.5})

    def test_calls_that_mean_nothing_become_one_diagnostic_each(self) -> None:
        messages = [remark["message"] for remark in self.graph["diagnostics"]]
        self.assertEqual(len(messages), 4)
        for said in ('ind_away_from_fixed_object(0, "radiator"): no feature "radiator"',
                     "ind_teleport(2): unknown function ind_teleport", "7: not a call",
                     "on_top_central(9, 0): no object 9"):
            self.assertTrue(any(said in message for message in messages), said)

    def test_odd_calls_cost_only_themselves(self) -> None:
        for call in (None, 3, [], {"function": 3}, {"args": [1]}, {"function": "io_near", "args": "0"},
                     {"function": "io_near", "args": [0, 1e300]}, {"function": "ind_next_to_wall", "args": [0.5]},
                     {"function": "io_near", "args": [0, [0, []]]},
                     {"function": "io_near", "args": [0, {}], "kwargs": 3}):
            with self.subTest(call):
                graph = read_graph(study_with("/calls/primary/0", call))
                self.assertEqual((len(graph["edges"]), len(graph["diagnostics"])), (12, 5))


class Refusals(unittest.TestCase):
    def test_name_field_value_and_what_would_be_right(self) -> None:
        cases = [('{\n"a":', "not JSON: parse error at line 2, column 5"),
                 ('{"room": {"width": NaN}}', "not JSON: parse error at line 1"), ("[1]", "[1] is not an object"),
                 (study_with("/room/width", "wide"), 'room.width: "wide" should be a number in (0, 100], metres'),
                 (study_with("/room/length", -3), "room.length: -3 should be a number in (0, 100], metres"),
                 (study_with("/room", {}), "room.width: is missing; should be a number in (0, 100], metres"),
                 (study_with("/zones/1", 4), "zones[1]: 4 should be text, a name"),
                 (study_with("/fixed_objects/0/wall", "up"),
                  'fixed_objects[0].wall: "up" should be south, east, north or west'),
                 (study_with("/primary/0/width", None), "primary[0].width: null should be a number in [0, 20], metres"),
                 (study_with("/secondary/1/length", 1e9), "secondary[1].length: 1000000000.0 should be a number"),
                 (study_with("/secondary/0/index", 0), "secondary[0].index: 0 should be a whole number that no other"),
                 (study_with("/primary/0/index", 0.5), "primary[0].index: 0.5 should be a whole number"),
                 (study_with("/primary/0/name", 7), "primary[0].name: 7 should be text"),
                 (study_with("/tertiary", 5), "tertiary: 5 should be a list"),
                 (study_with("/calls/tertiary", "none"), 'calls.tertiary: "none" should be a list'),
                 (study_with("/calls", None), "calls: null should be an object"), ("[" * 100_000, "nested too deep")]
        for text, said in cases:
            with self.subTest(said), self.assertRaises(BadProblem) as refused:
                read_graph(text)
            self.assertIn(said, str(refused.exception))
            self.assertTrue(str(refused.exception).startswith("not a recorded FlairGPT problem: "))

    def test_at_most_five_faults_are_listed(self) -> None:
        study = json.loads(TEXT)
        for made in study["tertiary"]:
            made["width"] = made["length"] = "x"
        with self.assertRaises(BadProblem) as refused:
            read_graph(json.dumps(study))
        self.assertEqual(str(refused.exception).count(";"), 4)

    def test_any_value_anywhere_is_read_or_refused(self) -> None:
        def places(value: object, at: tuple = ()) -> list[tuple]:
            inside = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else []
            return [at, *(place for name, one in inside for place in places(one, (*at, name)))]

        study = json.loads(TEXT)
        odd = (None, True, -1, 1e300, "x", [], {}, [[]])
        for i, place in enumerate(places(study)[1:]):
            changed = copy.deepcopy(study)
            inside = changed
            for name in place[:-1]:
                inside = inside[name]
            for value in (odd[i % len(odd)], odd[(3 * i + 1) % len(odd)]):
                inside[place[-1]] = value
                text = json.dumps(changed)
                try:
                    read_graph(text)
                except BadProblem:
                    continue
                read_placements(text)


class Functions(unittest.TestCase):
    def test_all_that_models_call_with_a_meaning_are_known(self) -> None:
        for name in (*FUNCTIONS, "p_next_to", "p_facing", "ind_not_facing", "ind_facing", "ind_away_from",
                     "io_min_dist", "io_accessible", "io_next_to_wall", "io_in_region", "ind_near", "on_top_center",
                     "on_wall_above"):
            self.assertTrue(canonical(name), name)
        for name in ("ind_near_plumbing_lines", "io_air_breaks", "ind_not_in_pathway", "in_bounds", ""):
            self.assertEqual(canonical(name), "", name)


class Layouts(unittest.TestCase):
    def test_a_round_trip_keeps_indices_sizes_and_poses(self) -> None:
        study = json.loads(TEXT)
        layout = {"graph": read_graph(TEXT), "placements": read_placements(TEXT)}
        written = judge_layout(layout, "small_study", 1.5)
        self.assertEqual((written["name"], written["seconds"], len(written["objects"])), ("small_study", 1.5, 7))
        recorded = [(role, one, pose) for role in ("primary", "secondary", "tertiary")
                    for one, pose in zip(study[role], study["solution"][role])]
        for made, (role, one, pose) in zip(written["objects"], recorded):
            self.assertEqual(made["role"], role)
            self.assertEqual([made[name] for name in ("name", "index", "width", "length")],
                             [one[name] for name in ("name", "index", "width", "length")])
            self.assertEqual([made["x"], made["y"]], pose[:2])
            self.assertAlmostEqual(math.remainder(made["theta"] - pose[2], math.tau), 0)
            self.assertTrue(0 <= made["theta"] < math.tau)

    def test_there_is_none_when_poses_are_missing(self) -> None:
        for text in (study_with("/solution", None), study_with("/solution/primary", []),
                     study_with("/solution/primary/0", [1])):
            self.assertIsNone(read_placements(text))

    def test_objects_of_other_graphs_are_numbered_in_order(self) -> None:
        objects = [{"id": name, "name": name, "role": f"OBJECT_ROLE_{role}", "width_m": 1, "depth_m": 1}
                   for name, role in (("bed_1", "PRIMARY"), ("lamp_9999999999999", "PRIMARY"), ("rug", "TERTIARY"))]
        layout = {"graph": {"object_list": {"objects": objects}},
                  "placements": [{"object_id": made["id"]} for made in objects]}
        self.assertEqual([made["index"] for made in judge_layout(layout, "own", 0)["objects"]], [0, 1, 0])


if __name__ == "__main__":
    unittest.main()
