# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels that are read or refused, and what of a translation is right."""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1] / "flairgpt")]

from labels import BadLabels, Bullet, Call, Label, Labels  # noqa: E402
from score import Score, meets, outcomes_of  # noqa: E402

CABIN = Path(__file__).parent / "testdata/translate"


def line(gold: object, **more: object) -> str:
    label = {"room": "cabin", "list": "primary_intra", "subject_index": [0], "sentence": "s", "gold": gold}
    return json.dumps(label | more)


class Files(unittest.TestCase):
    def read(self, text: str) -> Labels:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "labels.jsonl").write_text(text + "\n", encoding="utf-8")
        return Labels(folder, CABIN / "rooms")

    def test_lines_of_one_bullet_are_facts_of_one_sentence(self) -> None:
        room = Labels(CABIN, None).rooms["cabin"]
        self.assertEqual(len(room.bullets), 9)
        self.assertEqual(room.bullets[4].text, "The stool stands in front of the desk, at least 1m from the bunk.")
        self.assertEqual(len(room.bullets[4].labels), 2)
        self.assertEqual(room.bullets[7].subjects, ["item_0"])

    def test_calls_are_in_our_words(self) -> None:
        gold = [[{"function": "io_away_from", "objects": [0, 2], "params": {"min_dist": 1}}],
                [{"function": "p_next_to", "objects": [0, 1], "params": {"side1": "left"}}],
                [{"function": "ind_accessible", "objects": [0], "params": {"sides": ["long sides"]}}]]
        label = self.read(line(gold)).rooms["cabin"].bullets[0].labels[0]
        self.assertEqual([calls[0].text() for calls in label.alternatives[:2]],
                         ["away_from(object=floor_0, target=floor_2, min_distance_m=1)",
                          "next_to(object=floor_0, target=floor_1, object_side=left)"])
        self.assertEqual(len(label.alternatives[2][0].arguments["sides"]), 2)
        self.assertEqual(label.function, "io_away_from")

    def test_bad_lines_are_named_and_the_rest_is_read(self) -> None:
        labels = self.read('{"room": \n' + line([]) + "\n[1]")
        self.assertEqual(len(labels.rooms["cabin"].bullets), 1)
        self.assertEqual([failure.split(":", 1)[1] for failure in labels.failures],
                         ["1: not a JSON object", "3: not a JSON object"])

    def test_bad_labels_say_what_is_wrong(self) -> None:
        accessible = {"function": "ind_accessible", "objects": [0]}
        cases = [(line([[accessible | {"function": "ind_dance"}]]), "unknown function ind_dance"),
                 (line([[accessible | {"objects": [9]}]]), "no object 9"),
                 (line([[{"function": "io_near", "objects": [0]}]]), "too few for near"),
                 (line([[accessible | {"objects": [0, 1]}]]), "too many for accessible"),
                 (line([[accessible | {"params": {"hue": 1}}]]), "accessible has no hue"),
                 (line([[accessible | {"params": {"sides": ["up"]}}]]), 'unknown side "up"'),
                 (line([[]]), "an alternative without calls"), (line([[3]]), "3 is not a call"),
                 (line(7), "gold: missing"),
                 (line([], list="gossip"), "unknown list gossip"), (line([], room="palace"), "no palace.json"),
                 (line([], room="../cabin"), "not a file name"), ("", "no labels in it")]
        for text, said in cases:
            with self.subTest(said), self.assertRaisesRegex(BadLabels, said):
                self.read(text)


def against(**arguments: str) -> Call:
    return Call("against_wall", {"object": "a", **arguments})


class Meeting(unittest.TestCase):
    def test_a_call_meets_a_label_that_states_less(self) -> None:
        near = Call("near", {"object": "a", "target": "b"})
        beside = Call("next_to", {"object": "a", "target": "b", "object_side": "left", "target_side": "right"})
        turned = Call("next_to", {"object": "b", "target": "a", "object_side": "right", "target_side": "left"})
        for made, gold, right in [
                (against(), against(), True), (against(side="back"), against(), True),
                (against(side="left"), against(), False),
                (against(), against(side="back"), False), (Call("near", {"object": "b", "target": "a"}), near, True),
                (Call("in_front_of", {"object": "b", "target": "a"}), Call("in_front_of", near.arguments), False),
                (turned, beside, True), (Call("next_to", turned.arguments | {"object_side": "left"}), beside, False),
                (Call("accessible", {"object": "a"}), Call("accessible", {"object": "a", "sides": ["front"]}), True),
                (Call("accessible", {"object": "a"}), Call("accessible", {"object": "a", "sides": ["back"]}), False),
                (Call("near", near.arguments | {"max_distance_m": 0.6}), near, True)]:
            with self.subTest(f"{made.text()} {gold.text()}"):
                self.assertEqual(meets(made, gold), right)

    def test_a_stray_call_counts_against_the_first_clause_that_is_not_met(self) -> None:
        wall, near, stray = against(), Call("near", {"object": "a", "target": "b"}), Call("in_corner", {"object": "a"})
        bullet = Bullet("primary_intra", "s", [], [Label("x", [[wall]]), Label("refuse", []), Label("y", [[near]])])
        self.assertEqual(outcomes_of(bullet, []), ["refused", "correct", "refused"])
        self.assertEqual(outcomes_of(bullet, [wall]), ["correct", "correct", "missed"])
        self.assertEqual(outcomes_of(bullet, [wall, stray]), ["correct", "correct", "wrong"])
        self.assertEqual(outcomes_of(bullet, [wall, near, stray]), ["correct", "wrong", "correct"])

    def test_misses_name_what_was_wanted_made_and_remarked(self) -> None:
        score, wanted = Score(), Call("near", {"object": "floor_3", "target": "floor_0"})
        remark = {"subject_id": "s1", "code": "unknown_sentence", "message": "sings"}
        score.add("cabin", Bullet("tertiary", "It sings.", [], [Label("io_near", [[wanted]])]), "s1",
                  {"diagnostics": [remark]})
        edge = {"type": "near", "sentence_id": "s2",
                "arguments": [{"name": "object", "value": {"text": "floor_3"}},
                              {"name": "target", "value": {"text": "floor_0"}}]}
        score.add("cabin", Bullet("tertiary", "Near.", [], [Label("io_near", [[wanted]])]), "s2", {"edges": [edge]})
        self.assertEqual(score.misses, "cabin tertiary: It sings.\n  wanted   near(object=floor_3, target=floor_0)\n"
                                       "  remarked unknown_sentence: sings\n")
        self.assertRegex(score.text(), r"\ncabin +2 +1 +0 +0 +1 +50\.0\n")
        self.assertTrue(score.text().endswith("50.0 % of 2 labels correct\n"))


if __name__ == "__main__":
    unittest.main()
