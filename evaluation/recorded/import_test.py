# SPDX-License-Identifier: GPL-3.0-or-later
"""The command with the real programs: what becomes of two rooms, as a replayed design shows it."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
PROGRAMS = Path(os.environ["FLAIR_BIN"])


class Imported:
    """A room after its import and a design from the answers."""

    def __init__(self, name: str, folder: Path) -> None:
        self.answers = folder / "answers"
        self._run(sys.executable, HERE / "import_answers", HERE / f"testdata/{name}.json", "--out", self.answers)
        self._run(PROGRAMS / "flair", "design", "--brief", self.answers / "brief.json", "--replay", self.answers,
                  "--out", folder / "design", "--restarts", 1, "--size", 256, home=folder / "home")
        self.remarks = (self.answers / "remarks.txt").read_text(encoding="utf-8")
        self.room, objects, constraints = (self._artifact(folder, name) for name in ("room", "objects", "constraints"))
        self.objects = {made["id"]: made for made in objects["objects"]}
        self.sentences = constraints["sentences"]

    @staticmethod
    def _run(*command: object, home: Path | None = None) -> None:
        environment = os.environ | ({"FLAIR_HOME": str(home)} if home else {})
        parts = [str(part) for part in command]
        ended = subprocess.run(parts, env=environment, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise AssertionError(ended.stderr)

    @staticmethod
    def _artifact(folder: Path, name: str) -> dict:
        kinds = {"room": "room", "objects": "object_list", "constraints": "constraint_list"}
        return json.loads((folder / f"design/{name}.json").read_text(encoding="utf-8"))[kinds[name]]

    def sentences_of(self, scope: str) -> list[str]:
        return [f"{' '.join(one['subject_ids'])}: {one['text']}" for one in self.sentences
                if one["scope"] == f"SENTENCE_SCOPE_{scope}"]


class Rooms(unittest.TestCase):
    def imported(self, name: str) -> Imported:
        return Imported(name, Path(self.enterContext(tempfile.TemporaryDirectory())))

    def test_a_study_comes_through_with_hosts_sizes_and_sentences(self) -> None:
        study = self.imported("study")
        self.assertEqual(list(study.objects), ["desk", "armchair", "desk_chair", "bookshelf", "bookshelf_2",
                                               "desk_lamp", "painting", "rug", "books_1", "books_2"])
        self.assertEqual(study.objects["bookshelf"]["width_m"], 1)
        self.assertGreater(study.objects["bookshelf"]["height_m"], 1, "the handbook knows how high")
        self.assertEqual(study.objects["desk_lamp"]["host_id"], "desk")
        self.assertEqual(study.objects["painting"]["placement"], "On the wall above the desk.")
        self.assertEqual(study.objects["rug"]["host_id"], "armchair")
        self.assertEqual((len(study.room["openings"]), len(study.room["sockets"])), (2, 1))
        self.assertEqual(study.sentences_of("INTRA"), [
            "desk: Must not block the window.", "desk: Must not block the door.", "desk: Should be against a wall.",
            "desk: Near a power socket.", "armchair: The front should be accessible.",
            "armchair: Avoid placement near doors.", "desk_chair: Should be accessible from the back.",
            "bookshelf: Should be against a wall.", "bookshelf_2: Should be in a corner."])
        self.assertEqual(study.sentences_of("INTER"), [
            "desk armchair: The desk should be at least 0.6m away from the armchair.",
            "desk desk_chair: The desk chair should be in front of the desk.",
            "desk desk_chair: The desk chair should face the desk.",
            "armchair: Should be placed beside the bookshelf."])
        self.assertIn("primary_inter_clean, line 2 (names none of the objects): There should be room", study.remarks)
        self.assertIn("(belongs to none of the objects): Wind Chime: By the window.", study.remarks)
        records = [json.loads(path.read_text(encoding="utf-8")) for path in study.answers.glob("*-*.json")]
        self.assertEqual(len(records), 11)
        for record in records:
            self.assertNotIn("repair", record["step"])
            required = json.loads(record["request"]["schema"])["required"]
            self.assertLessEqual(set(required), set(json.loads(record["answer"]["text"])), record["step"])

    def test_a_washroom_is_turned_as_its_brief_says(self) -> None:
        washroom = self.imported("washroom")
        corner = washroom.room["floor"]["vertices"][2]
        self.assertEqual((corner["x_m"], corner["y_m"]), (3, 2))
        self.assertEqual([opening["wall"] for opening in washroom.room["openings"]], ["south", "north"])
        self.assertEqual(washroom.objects["bath_mat"]["role"], "OBJECT_ROLE_TERTIARY", "mats lie on the floor")
        self.assertIn("Placed on the floor.", washroom.remarks)
        self.assertEqual(washroom.objects["soap_dish"]["host_id"], "washbasin", "as its call says")
        self.assertEqual(washroom.objects["mirror"]["host_id"], "washbasin")
        self.assertEqual(washroom.objects["ceilinglight"]["kind"], "OBJECT_KIND_CEILING")


if __name__ == "__main__":
    unittest.main()
