# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs: whose layout is drawn, on which side, and how answers are counted."""

import math
import unittest

from pairs import OURS, RECORDED, BadPairs, count, deal_sides, recorded_layout, text

ROOM = {"name": "study", "primary": [{"index": 0}], "secondary": [{"index": 1}], "tertiary": [{"index": 0}],
        "solution": {"primary": [[1, 2, 0]], "secondary": [[3, 4, 0.5 + 4 * math.pi]], "tertiary": [[5, 6, 1]]}}


def layout_of(*ids: str) -> dict:
    return {"solved_layout": {"placements": [{"object_id": name, "x_m": 0, "y_m": 0, "z_m": 0.7, "theta_rad": 0}
                                             for name in ids]}}


class RecordedLayout(unittest.TestCase):
    def test_has_the_recorded_poses_and_leaves_ours_alone(self):
        ours = layout_of("floor_1", "item_0")
        made = recorded_layout(ours, ROOM)["solved_layout"]["placements"]
        self.assertAlmostEqual(made[0].pop("theta_rad"), 0.5)
        self.assertEqual(made[0], {"object_id": "floor_1", "x_m": 3, "y_m": 4, "z_m": 0.7})
        self.assertEqual(made[1]["x_m"], 5)
        self.assertEqual(ours, layout_of("floor_1", "item_0"))

    def test_names_a_piece_without_one(self):
        with self.assertRaisesRegex(BadPairs, "study: no recorded pose of floor_7"):
            recorded_layout(layout_of("floor_7"), ROOM)


class Sides(unittest.TestCase):
    NAMES = [f"room_{number}" for number in range(40)]

    def test_are_the_same_for_a_seed_and_others_for_another(self):
        self.assertEqual(deal_sides(self.NAMES, 3), deal_sides(list(reversed(self.NAMES)), 3))
        self.assertNotEqual(deal_sides(self.NAMES, 3), deal_sides(self.NAMES, 4))

    def test_have_both_on_each(self):
        for sides in deal_sides(self.NAMES, 3).values():
            self.assertEqual({sides["left"], sides["right"]}, {OURS, RECORDED})
        left = sum(sides["left"] == OURS for sides in deal_sides(self.NAMES, 3).values())
        self.assertTrue(10 <= left <= 30, left)


class Counting(unittest.TestCase):
    KEY = {"study": {"left": OURS, "right": RECORDED}, "hall": {"left": RECORDED, "right": OURS}}

    def test_goes_by_room_and_by_answer(self):
        tally = count(self.KEY, [{"room": "study", "answer": "left"}, {"room": "study", "answer": "right"},
                                 {"room": "study", "answer": "left"}, {"room": "hall", "answer": "left"},
                                 {"room": "hall", "answer": "equal"}])
        self.assertEqual(tally.rooms, {OURS: 1, RECORDED: 1})
        self.assertEqual(tally.answers, {OURS: 2, RECORDED: 2, "equal": 1})
        self.assertIn("study                            2         1      0", text(tally))

    def test_refuses_what_it_does_not_know(self):
        with self.assertRaisesRegex(BadPairs, "'attic' is not in the key"):
            count(self.KEY, [{"room": "attic", "answer": "left"}])
        with self.assertRaisesRegex(BadPairs, "study: answer 'both'; one of left, right, equal"):
            count(self.KEY, [{"room": "study", "answer": "both"}])


if __name__ == "__main__":
    unittest.main()
