# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of briefs, layouts as the program writes them, verdicts and tables."""

import json
import tempfile
import unittest
from pathlib import Path

import checks
import verdicts
from plan import Piece, Plan, Wall, read_plan
from wishes import BadExam, Brief, fault_of_wish, read_exam, remark_on

HERE = Path(__file__).resolve().parent
WISH = {"wish": "a desk", "check": "count", "of": "desk", "exactly": 1, "remark": ["desk"]}
SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]


def plan(*remarks: str, pieces: tuple[Piece, ...] = ()) -> Plan:
    walls = [Wall(begin, end) for begin, end in zip(SQUARE, SQUARE[1:] + SQUARE[:1])]
    return Plan(walls, remarks=list(remarks), pieces=list(pieces))


class Files(unittest.TestCase):
    def setUp(self) -> None:
        self.file = Path(self.enterContext(tempfile.TemporaryDirectory())) / "mine.jsonl"

    def read(self, *lines: object):
        self.file.write_text("".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines))
        return read_exam(self.file)

    def test_the_sets_of_this_folder_can_be_read(self) -> None:
        names = ("development", "second", "third", "fourth")
        development, second, third, fourth = sets = [read_exam(HERE / f"{name}.jsonl") for name in names]
        self.assertFalse(development.misses_hidden)
        self.assertTrue(second.misses_hidden and third.misses_hidden and fourth.misses_hidden)
        self.assertGreaterEqual(sum(len(exam.briefs) for exam in sets), 100)
        asked = {wish["check"] for exam in sets for brief in exam.briefs for wish in brief.wishes}
        self.assertEqual(asked, set(checks.CHECKS), "every check is asked for somewhere")
        texts = [brief.text for exam in sets for brief in exam.briefs]
        self.assertEqual(len(texts), len(set(texts)))

    def test_one_line_is_a_brief(self) -> None:
        exam = self.read({"id": "a", "brief": "A desk.", "wishes": [WISH]})
        self.assertEqual((exam.name, exam.misses_hidden, exam.briefs), ("mine", False, [Brief("a", "A desk.", [WISH])]))

    def test_faults_name_line_and_field(self) -> None:
        brief = {"id": "a", "brief": "A desk.", "wishes": [WISH]}
        cases = {
            "no brief": [],
            ":1: Expecting value at column 1": ["nonsense"],
            ":1: is no JSON object": ["[]"],
            ":1: brief is null; a text": [{"id": "a", "wishes": [WISH]}],
            ":2: id a is that of an earlier brief": [brief, brief],
            ":1: wishes is []; a list of wishes": [{**brief, "wishes": []}],
            ":1: wish 2: check is \"counts\"; one of count,": [
                {**brief, "wishes": [WISH, {**WISH, "check": "counts"}]}],
            ":1: misses is \"no\"; one of shown, hidden": [{"set": "x", "misses": "no"}, brief],
        }
        for fault, lines in cases.items():
            with self.subTest(fault), self.assertRaises(BadExam) as raised:
                self.read(*lines)
            self.assertIn(fault, str(raised.exception))

    def test_faults_of_a_wish_say_what_would_be_right(self) -> None:
        near = {"wish": "near", "check": "near", "of": "desk", "to": "sofa", "remark": ["desk"]}
        cases = [
            ({**WISH, "remark": []}, "remark is []; a list of words"),
            ({**WISH, "of": "@desks"}, "of names the group @desks; known are @standing, @bed"),
            ({**WISH, "exactly": "one"}, 'exactly is "one"; a number from 0'),
            ({**WISH, "exactly": True}, "exactly is true; a number from 0"),
            ({**WISH, "within_m": 1}, "within_m is no field of the check count; known are"),
            ({name: value for name, value in WISH.items() if name != "exactly"}, "says no number; exactly, at_least"),
            ({**near, "within_m": -1}, "within_m is -1; a number from 0"),
            ({**near, "to": []}, "to is no name and no list of names"),
            ({**near, "all": 1}, "all is 1; true or false"),
            ({**near, "check": "opening_walls", "opening": "hatch", "walls": ["east"]},
             'opening is "hatch"; one of door, window'),
            ({**near, "check": "between"}, "ends is missing"),
            ({**near, "check": "at_wall", "wall": "up"}, 'wall is "up"; one of north'),
        ]
        for wish, fault in cases:
            with self.subTest(fault):
                self.assertIn(fault, fault_of_wish(wish))
        self.assertEqual(fault_of_wish(near), "")


class Layouts(unittest.TestCase):
    def test_a_layout_is_read_as_the_program_writes_it(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        sentences = [{"id": "s1", "text": "The desk is near the door.", "reason": "the brief asks for it",
                      "origin": "SENTENCE_ORIGIN_BRIEF"},
                     {"id": "s2", "text": "The desk is near a socket.", "reason": "cables stay short"}]
        graph = {
            "room": {"room_type": "study", "floor": {"vertices": [{}, {"x_m": 4}, {"x_m": 4, "y_m": 3}, {"y_m": 3}]},
                     "walls": [{"name": name} for name in ("a", "b", "c", "d")],
                     "openings": [{"kind": "OPENING_KIND_DOOR", "wall": "c", "offset_m": 0.5, "width_m": 0.9}]},
            "object_list": {"objects": [{"id": "desk_1", "name": "desk", "kind": "OBJECT_KIND_FLOOR", "width_m": 1.2,
                                         "depth_m": 0.6}], "omissions": [{"name": "safe", "reason": "no room for it"}]},
            "constraint_list": {"sentences": sentences},
            "edges": [{"id": "e1", "sentence_id": "s1"}, {"id": "e2", "sentence_id": "s2"}],
        }
        outcomes = [{"edge_id": edge, "status": "OUTCOME_STATUS_VIOLATED"} for edge in ("e1", "e2")]
        layout = {"graph": graph, "placements": [{"object_id": "desk_1", "x_m": 1}], "edge_outcomes": outcomes}
        report = {"diagnostics": [{"code": "size_assumed", "message": "The brief gives no size."},
                                  {"code": "words_not_known", "message": "No word for \"slide\"."}]}
        (folder / "layout.json").write_text(json.dumps({"solved_layout": layout}))
        (folder / "report.json").write_text(json.dumps({"report": report}))
        read = read_plan(folder / "layout.json", folder / "report.json")
        self.assertEqual(read.pieces, [Piece("desk", 1, 0.0, 0.0, 1.2, 0.6)])
        self.assertEqual([wall.compass for wall in read.walls], ["south", "east", "north", "west"])
        self.assertEqual((read.size_m(), read.area_m2(), read.room_type), ((4, 3), 12, "study"))
        self.assertEqual((read.openings[0].kind, read.openings[0].begin_m), ("door", (3.5, 3.0)))
        self.assertEqual(read.remarks, ['No word for "slide".', "safe: no room for it",
                                        "The desk is near the door. (the brief asks for it)"])


class Verdicts(unittest.TestCase):
    def outcome(self, found: Plan | None) -> str:
        return verdicts.judge(Brief("a", "A desk.", [WISH]), found)[0].outcome

    def test_what_is_met_is_obeyed_whatever_is_remarked(self) -> None:
        self.assertEqual(self.outcome(plan("The desk is odd.", pieces=(Piece("desk", 1, 1, 0.0, 1, 1),))), "obeyed")

    def test_a_remark_that_names_it_reports_it(self) -> None:
        self.assertEqual(self.outcome(plan("No room for desks.")), "reported")
        self.assertEqual(self.outcome(plan("desk_1: left out")), "reported")

    def test_other_remarks_do_not(self) -> None:
        self.assertEqual(self.outcome(plan("The desktop is small.", "No bed.")), "silent")

    def test_no_plan_is_a_failure(self) -> None:
        self.assertEqual(self.outcome(None), "failed")

    def test_the_remark_is_the_first_that_has_a_word(self) -> None:
        self.assertEqual(remark_on(plan("A bed.", "A desk.", "Desks."), WISH), "A desk.")

    def test_the_table_counts_and_the_list_names_the_brief_once(self) -> None:
        brief = Brief("a", "Two desks.", [WISH, {**WISH, "wish": "again"}])
        judged = verdicts.judge(brief, plan()) + verdicts.judge(brief, plan("desk"))
        self.assertRegex(verdicts.table(judged), r"count +4 +0 +2 +2 +0\nall +4 +0 +2 +2 +0\n0 % obeyed$")
        self.assertEqual(verdicts.misses(judged, "silent"),
                         "  a: Two desks.\n      a desk (count)\n      again (count)")


if __name__ == "__main__":
    unittest.main()
