# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a few records, worked out by hand."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))

from tables import SHOW, Table, hits, mean, quantile, restarts_curve  # noqa: E402

QUALITY = {"held": 3, "missed": 1, "oob_percent": 0, "oor_percent": 0.5, "deepest_overlap_m": 0.002,
           "oob_3d_percent": 0, "oor_3d_percent": 0, "reachable_floor_share": 0.9, "reachable_front_share": 1,
           "pathway_cost_m3": 0.01}


def solve(name: str, cpu_s: float, recorded: dict | None = None) -> dict:
    stage = {"cost": 1.5, "restarts": 4, "evaluations": 2000, "cpu_s": cpu_s / 2}
    return {"name": name, "objects": 5, "cpu_s": cpu_s, "restarts": 8, "evaluations": 4000,
            "stages": {"primary": stage, "secondary": stage}, "memory_mib": {"before": 10, "after": 12},
            "ours": QUALITY, **({"recorded": recorded} if recorded else {})}


def shown(kind: str, records: list[dict], each: bool = False) -> str:
    return "".join(SHOW[kind](iter(records), each))


class Statistics(unittest.TestCase):
    def test_quantiles_are_values_of_the_sample(self) -> None:
        self.assertEqual(quantile([], 0.5), 0)
        self.assertEqual([quantile([3, 1, 2], share) for share in (0, 0.5, 1)], [1, 2, 3])
        self.assertEqual(mean([1, 2, 6]), 3)

    def test_rows_are_as_long_as_their_titles(self) -> None:
        table = Table(["room", "objs"], 8)
        self.assertEqual(table.header(), "room       objs\n---------------\n")
        self.assertEqual(table.row(["a long name", "12"]), "a long n     12\n")


class Solves(unittest.TestCase):
    def test_the_summary_compares_with_the_recorded_layout(self) -> None:
        recorded = QUALITY | {"held": 2, "missed": 2, "oor_percent": 1}
        text = shown("solve", [solve("hall", 0.2, recorded), solve("den", 0.4)])
        self.assertRegex(text, r"\nhall +5 +200 +8 +4 +1\.500 ")
        self.assertRegex(text, r"\nden .* 3 +1 +- +-\n")
        self.assertIn("2 rooms: CPU median 0.400 s, mean 0.300 s", text)
        self.assertIn("6 of 8 constraints hold (75.0 %)", text)
        self.assertIn("10.0 MiB before the first solve, 12.0 MiB at most", text)
        self.assertIn("mean over 1 room with a recorded layout", text)
        self.assertRegex(text, r"constraints that hold, by our terms +0\.7500 +0\.5000 +1\.500 +1 room\n")
        self.assertRegex(text, r"OOR, % of the room +0\.5000 +1\.0000 +0\.500 +1 room\n")

    def test_nothing_measured_shows_nothing(self) -> None:
        for kind in SHOW:
            self.assertEqual(shown(kind, []), "")


class Edits(unittest.TestCase):
    def test_rooms_and_kinds_have_a_line_each(self) -> None:
        edit = {"room": "hall", "edit": "pin desk", "cpu_s": 0.01, "moved": 2, "held_before": 4, "held_after": 3,
                "deepest_overlap_m": 0.001}
        text = shown("resolve", [edit, edit | {"edit": "move desk 1 2", "cpu_s": 0.03}], each=True)
        self.assertRegex(text, r"^hall +pin desk +10\.0 ms   2 moved, 4 -> 3\n")
        self.assertRegex(text, r"\nall: move +1 +30\.0 +30\.0 +30\.0 +2\.00 +4\.00 +3\.00 +1\.000\n")
        self.assertRegex(text, r"\nall +2 +30\.0 ")


class Restarts(unittest.TestCase):
    def test_hits_are_within_a_hundredth_of_the_best(self) -> None:
        self.assertEqual(hits({"scores": [10, 8.07, 8, 8.09]}), [False, True, True, False])

    def test_the_curve_ends_with_all_restarts_at_the_best(self) -> None:
        room = {"name": "a", "scores": [3, 2, 1, 4, 5], "cpu_s": [1, 1, 1, 1, 1]}
        self.assertRegex(restarts_curve([room]), r"\n1 +0\.0 +2\.0000 +1000\.0\n2 +0\.0 +1\.0000 +2000\.0\n"
                                                 r"4 +100\.0 +0\.0000 +4000\.0\n5 +100\.0 +0\.0000 +5000\.0\n$")
        self.assertRegex(shown("restarts", [room]), r"\na +1\.0000 +2 +20\.0 +1000\.00\n")


class Renders(unittest.TestCase):
    def test_the_slowest_room_of_each_kind_is_named(self) -> None:
        rooms = [{"room": name, "object_count": 3, "plan PNG": {"cpu_s": cpu_s, "bytes": 2048}}
                 for name, cpu_s in (("a", 0.1), ("b", 0.3), ("c", 0.2))]
        self.assertRegex(shown("render", rooms), r"^3 rooms\nCPU .*\nplan PNG +200\.0 +300\.0 +300\.0 +2  b\n$")


if __name__ == "__main__":
    unittest.main()
