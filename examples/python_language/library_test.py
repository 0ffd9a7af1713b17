# SPDX-License-Identifier: GPL-3.0-or-later
"""Which room a brief gets, and what is said of a folder that cannot be used."""

import shutil
import tempfile
import unittest
from pathlib import Path

from library import BadLibrary, choose, read_library

ROOMS = Path(__file__).resolve().parent / "rooms"


class Choosing(unittest.TestCase):
    def test_the_room_type_that_the_brief_names_decides(self) -> None:
        rooms = read_library(ROOMS)
        cases = {
            "A bedroom that is 4m x 5m.": "bedroom",
            "A MUSIC ROOM, please": "music_room",
            "A room where one plays music.": "music_room",
            "A music room that was a bedroom": "music_room",  # two words against one
        }
        for text, name in cases.items():
            with self.subTest(text):
                self.assertEqual(choose(rooms, text, 0).name, name)

    def test_a_brief_that_names_none_gets_none(self) -> None:
        self.assertIsNone(choose(read_library(ROOMS), "A ballroom.", 0))

    def test_among_equals_the_seed_decides(self) -> None:
        rooms = read_library(ROOMS)
        twins = [rooms[0], rooms[0], rooms[1]]
        self.assertIs(choose(twins, "A bedroom.", 0), choose(twins, "A bedroom.", 2))
        self.assertIsNotNone(choose(twins, "A bedroom.", 1))


class Reading(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.rooms = Path(folder.name) / "rooms"
        shutil.copytree(ROOMS / "bedroom", self.rooms / "bedroom")

    def refusal(self) -> str:
        with self.assertRaises(BadLibrary) as caught:
            read_library(self.rooms)
        return str(caught.exception)

    def test_an_empty_folder_is_refused(self) -> None:
        shutil.rmtree(self.rooms / "bedroom")
        self.assertIn(f"{self.rooms}: no rooms", self.refusal())

    def test_a_missing_file_is_named(self) -> None:
        (self.rooms / "bedroom" / "style.json").unlink()
        self.assertIn("bedroom/style.json", self.refusal())

    def test_a_field_that_does_not_exist_is_named_with_its_file(self) -> None:
        (self.rooms / "bedroom" / "room.json").write_text('{"colour": 1}')
        self.assertRegex(self.refusal(), 'room.json: .*"colour"')

    def test_an_object_of_a_zone_that_is_not_there_is_named(self) -> None:
        (self.rooms / "bedroom" / "zones.json").write_text('{"zones": [{"id": "sleeping", "name": "sleeping"}]}')
        self.assertIn('object_list.objects[1].zone_id: "dressing" is not a zone', self.refusal())


if __name__ == "__main__":
    unittest.main()
