# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, lists, prompts and figures that are read, and that any text is."""

import json
import random
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1] / "flairgpt")]

from answers import Answers  # noqa: E402
from handbook import colour_in, height_of, kind_of_room, turned  # noqa: E402
from lists import Conversion, read_constraints, read_looks, read_places  # noqa: E402
from names import Names, Thing, find_zone, likeness, name_key, split_sentences  # noqa: E402
from prompts import read_asked, read_listed  # noqa: E402
from room import BadRoom, Call, Room, is_rug, read_problem  # noqa: E402

STUDY = Path(__file__).parent / "testdata/study.json"


def thing(name: str, width_m: float = 0.5, depth_m: float = 0.5, zone: str = "", role: str = "secondary",
          kind: str = "floor") -> Thing:
    return Thing(f"id_{name}_{width_m}", name, role, kind, zone, width_m, depth_m)


FLOOR = [thing("desk", 1.4, 0.7, "working", "primary"), thing("desk chair", 0.5, 0.5, "working"),
         thing("bookshelf", 1.0, 0.3, "reading"), thing("bookshelf", 0.6, 0.3, "working"),
         thing("nightstand", 0.4, 0.4, "sleeping"), thing("nightstand", 0.4, 0.4, "sleeping"),
         thing("alchemy table", 1.5, 1, "working"), thing("tv_stand", 1.2, 0.4, "reading")]


class FoundNames(unittest.TestCase):
    def found(self, text: str, zone: str = "") -> list[int]:
        return [i for mention in Names(FLOOR).find(text, zone) for i in mention.things]

    def test_the_longest_name_counts_in_any_form(self) -> None:
        self.assertEqual(self.found("The Desk Chair should be before the desk."), [1, 0])
        self.assertEqual(self.found("Both nightstands, the TV-stand and bookshelves"), [4, 5, 7, 2, 3])
        self.assertEqual(self.found("deskside desktops"), [])

    def test_size_number_and_zone_choose_among_equal_names(self) -> None:
        for text, expected in [("Bookshelf (0.6m x 0.3m)", [3]), ("Bookshelf - Width: 1m, Length: 0.3m", [2]),
                               ("Bookshelf (0.3m length x 0.6m width)", [3]), ("Bookshelf (7m x 9m)", [2, 3]),
                               ("the bookshelf is at least 0.6m from 0.3m", [2, 3]), ("On nightstand 2.", [5]),
                               ("Nightstand (1)", [4]), ("Nightstand 0.4m", [4, 5]), ("Nightstand 9", [4, 5])]:
            with self.subTest(text):
                self.assertEqual(self.found(text), expected)
        self.assertEqual(self.found("the bookshelf", "working"), [3])
        self.assertEqual(self.found("the bookshelf", "sleeping"), [2, 3])

    def test_a_word_of_one_name_is_enough_where_no_name_is(self) -> None:
        names = Names(FLOOR)
        self.assertEqual([mention.things for mention in names.find_loosely("The Alchemical table")], [[6]])
        self.assertEqual(len(names.find_loosely("the chair by the table")), 2)
        self.assertEqual(names.find_loosely("by the wall"), [])

    def test_keys_of_names_and_ids_are_equal(self) -> None:
        self.assertEqual(name_key("dining chairs"), name_key("dining_chair_3"))
        self.assertEqual(name_key("Night stand"), name_key("nightstand_12"))
        self.assertNotEqual(name_key("desk"), name_key("desk chair"))
        self.assertEqual(name_key("4 chairs"), "4chair")

    def test_a_zone_stands_among_the_first_words(self) -> None:
        zones = ["living_area", "work"]
        self.assertEqual(find_zone("Living Area:", zones), "living_area")
        self.assertEqual(find_zone("Work: Desk", zones), "work")
        self.assertEqual(find_zone("A place to rest after work", zones), "")

    def test_sentences_end_where_a_capital_follows_but_not_in_brackets(self) -> None:
        self.assertEqual(split_sentences("One is 0.5m wide. Two (e.g. Beams. And so on) is not. Three"),
                         ["One is 0.5m wide.", "Two (e.g. Beams. And so on) is not.", "Three"])
        self.assertEqual(split_sentences("near e.g. Windows"), ["near e.g. Windows"])
        self.assertEqual(split_sentences("   "), [])

    def test_likeness_is_the_share_of_the_shorter_texts_words(self) -> None:
        self.assertEqual(likeness("The desk should be against a wall.", "Desk should be against the wall, safe"), 1)
        self.assertEqual(likeness("against a wall", ""), 0)
        self.assertAlmostEqual(likeness("near door window", "near door socket lamp"), 2 / 3)

    def test_rugs_are_known_by_their_last_word(self) -> None:
        self.assertTrue(is_rug("bath mats"))
        self.assertFalse(is_rug("table runner"))


class Constraints(unittest.TestCase):
    THINGS = [thing(name) for name in ("desk", "armchair", "desk chair", "potted plant", "potted plant")]

    def read(self, text: str, intra: bool) -> list[str]:
        """"0 1: text" for each sentence."""
        self.conversion = Conversion()
        found = read_constraints("t", text, intra, Names(self.THINGS), ["working", "reading"], self.conversion)
        return [f"{' '.join(map(str, one.things))} {'! ' if one.must else ''}{one.text}" for one in found]

    def test_items_are_about_the_thing_of_their_heading(self) -> None:
        cases = [
            ("Sure! Here is the list for each object:\n\n### Working: Desk - 1.4m x 0.7m\n- Should be against a wall.\n"
             "- **Access**: the front must be free.\n### Desk Chair\n- Near the desk.\n\nThese keep it practical.",
             ["0 Should be against a wall.", "0 ! Access: the front must be free.", "2 Near the desk."]),
            ("### Desk\n- **Distance from the armchair:**\n  - Should be 1m.\n- **Desk Chair (0.5m x 0.5m)**\n"
             "  - Should be free.", ["0 Should be 1m.", "2 Should be free."]),
            ("### Desk\n- Avoid placement near:\n  - Doors\n  - Windows\n",
             ["0 Avoid placement near Doors", "0 Avoid placement near Windows"]),
            ("**1. Reading:\n- Armchair: 0.8m (width) x 0.8m (length)**\n\n- Should face the room.\n"
             "**2. Working:\n- Desk: 1.4m (width) x 0.7m (length)**\n\n- Should be free.\n",
             ["1 Should face the room.", "0 Should be free."]),
            ("- **Potted Plants (x2)**\n  - Should not block doors.", ["3 4 Should not block doors."])]
        for text, expected in cases:
            with self.subTest(text):
                self.assertEqual(self.read(text, intra=True), expected)

    def test_pairs_are_those_of_the_heading_else_those_that_the_sentence_names(self) -> None:
        self.assertEqual(
            self.read("1. **Desk and Desk Chair**:\n   - Constraint: The chair should be in front.\n"
                      "2. The armchair should be away from the desk. It should face the potted plants.\n", intra=False),
            ["0 2 The chair should be in front.", "1 0 The armchair should be away from the desk.",
             "1 3 4 It should face the potted plants."])
        self.assertEqual(self.read("1. Working:\n   - Desk Chair:\n     - Should be at the desk.\n   - Armchair:\n"
                                   "     - Near.", intra=False), ["2 Should be at the desk.", "1 Near."])

    def test_what_names_nothing_is_kept_and_marks_say_nothing(self) -> None:
        self.assertEqual(self.read("1. Maintain a clear path through the room.\n", intra=False), [])
        self.assertEqual(self.conversion.remarks,
                         ["t, line 1 (names none of the objects): Maintain a clear path through the room."])
        self.assertEqual((self.conversion.lines, self.conversion.converted), (1, 0))
        self.assertEqual(self.read("---\n```\n• The **desk** is at the `wall`.\n***\n3) *The desk is 3.5 m from it.*\n",
                                   intra=False), ["0 The desk is at the wall.", "0 The desk is 3.5 m from it."])


class Prompts(unittest.TestCase):
    def test_objects_of_the_steps_and_of_the_translation(self) -> None:
        chairs = read_listed("Furniture:\n- table* (dining): 1 x 2 x 0.7 m\n"
                             "- chair_1 to chair_12, together dining chair (dining): 0.45 x 0.5 x 0.9 m\nSay - now.")
        self.assertEqual([line.group for line in chairs], ["table", "dining chair"])
        self.assertEqual((len(chairs[1].ids), chairs[1].ids[11], chairs[1].zone), (12, "chair_12", "dining"))
        bed, stools = read_listed('- bed_1: "double bed", 1.6 x 2, sleeping\n'
                                  "- stool_1, stool_2: 0.2 x 0.2, no zone, on another object\n"
                                  "- near(object, target): a function, 2 x 3, that\n")
        self.assertEqual((bed.ids, bed.name, bed.depth_m, bed.zone), (["bed_1"], "double bed", 2, "sleeping"))
        self.assertEqual((stools.ids, stools.name, stools.zone), (["stool_1", "stool_2"], "stool", ""))

    def test_groups_that_cannot_be_are_not_read_for(self) -> None:
        line = "- a_1 to a_999999999, together a (z): 1 x 1 x 1 m"
        self.assertLess(len(read_listed(line)[0].ids), 300)
        self.assertEqual(read_listed("- a_9 to a_2, together a (z): 1 x 1 x 1 m")[0].ids, ["a_9"])

    def test_sentences_under_their_headings(self) -> None:
        asked = read_asked('Sentences:\n[bed, desk_2]\n- s1 "The \\"bed\\" is near."\n- s2a "Alone."\n'
                           'not [a] sentence\n[]\n- s3 bare\n- s4 "Of none."\n')
        self.assertEqual([(one.id, one.subjects, one.text) for one in asked],
                         [("s1", ["bed", "desk_2"], 'The "bed" is near.'), ("s2a", ["bed", "desk_2"], "Alone."),
                          ("s4", [], "Of none.")])


class Handbook(unittest.TestCase):
    def test_heights_and_kinds_of_room_are_the_handbooks(self) -> None:
        self.assertEqual(height_of(thing("oak desk")), 0.74)
        self.assertEqual(height_of(thing("gizmo")), 0.8)
        self.assertEqual(height_of(thing("gizmo", role="tertiary", kind="wall")), 0.5)
        self.assertEqual(kind_of_room("A green, small, boho dining room."), "dining room")
        self.assertEqual(kind_of_room("A thing."), "room")

    def test_looks_are_told_under_the_name_of_what_has_them(self) -> None:
        text = ("**Walls:**\n- **Covering:** Paper.\n- **Colour:** Sage green\n\n1. **Desk**\n"
                "   - **Colour**: Dark brown\n2. **Nightstand 1 & 2:** Off-white.\n3. **Rug**\n   - Soft.\n")
        self.assertEqual(read_looks(text, ["walls", "desk", "nightstand", "rug"], colour_in),
                         {"walls": "Sage green", "desk": "Dark brown", "nightstand": "Off-white."})
        self.assertEqual(colour_in("Off-white."), "off-white")

    def test_a_room_may_be_recorded_the_other_way_round(self) -> None:
        self.assertTrue(turned("A washroom, 3m x 2m.", 2, 3))
        self.assertFalse(turned("A washroom, 3m x 2m.", 3, 2))
        self.assertFalse(turned("A washroom.", 2, 3))


class Files(unittest.TestCase):
    def test_others_are_refused_with_the_field(self) -> None:
        study = json.loads(STUDY.read_text(encoding="utf-8"))
        cases = [("", "Expecting value"), ("[]", "prompt"), (json.dumps(study | {"prompt": "  "}), "prompt"),
                 (json.dumps(study | {"language": None}), "language: "), (" " * 11_000_000, "at most"),
                 (json.dumps(study | {"language": {"style": [1]}}), "language.style: should be text")]
        for content, said in cases:
            with self.subTest(said), self.assertRaisesRegex(BadRoom, said):
                read_problem(content.encode())


PIECES = ["#", "### ", "- ", "* ", "**", "`", "1. ", "99) ", "\n", "\n\n", "\n   ", "\t", ":", ": ", "(", ")", "desk",
          "bookshelves", "nightstand 2", "Bookshelf (1.0m x 0.3m)", "should", "Placement:", "walnut", "0.5m", "1e999m",
          "x", ".", ". A", "e.g. ", "\xc3", "’", "\r", "Reading:", "window", "wall", "Summary", "- Object: desk_lamp",
          '"', "\\", 's1 [desk] "x"', "2x", "working", "Avoid placement near:"]


class AnyText(unittest.TestCase):
    ITEMS = [thing("desk_lamp", role="tertiary", kind="surface"), thing("painting", role="tertiary", kind="wall")]

    def read_all(self, text: str) -> None:
        conversion = Conversion()
        for intra in (True, False):
            for one in read_constraints("t", text, intra, Names(FLOOR), ["working", "reading"], conversion):
                self.assertTrue(one.text and one.things and len(one.text) <= 390, repr(text))
        self.assertEqual(len(read_places(text, self.ITEMS, Names(FLOOR), conversion)), len(self.ITEMS))
        self.assertLessEqual(conversion.converted, conversion.lines, repr(text))

    def test_is_read(self) -> None:
        made = random.Random(4)
        for _ in range(100):
            self.read_all("".join(made.choice(PIECES) for _ in range(made.randrange(120))))

    def test_deep_lists_and_long_lines_take_no_long_time(self) -> None:
        self.read_all("".join(" " * i + "- desk:\n" for i in range(3000)))
        self.read_all("- " + "desk " * 200_000)

    def test_gives_answers(self) -> None:
        made, texts = random.Random(5), json.loads(STUDY.read_text(encoding="utf-8"))["language"]
        for _ in range(20):
            changed = {}
            for name, text in texts.items():
                at = made.randrange(len(text))
                changed[name] = text[:at] + made.choice(PIECES) + text[at + made.randrange(20):]
            room = Room("A study.", "0", 4, 3, [], [], {"working": "working"}, FLOOR + self.ITEMS,
                        [Call("near", [("object", ["id_desk_1.4"])])], changed)
            for form in ("room", "zones", "floor_objects", "tertiaries", "intra", "inter", "style", "cleaning"):
                self.assertTrue(Answers(room).to(f"{form}_answer", "- desk* (working): 1.4 x 0.7 x 0.7 m"))


if __name__ == "__main__":
    unittest.main()
