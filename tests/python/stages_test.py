# SPDX-License-Identifier: GPL-3.0-or-later
"""The stages in Python, each a process of its own: the contract, and designs through them."""

import re
import tempfile
import unittest
from collections.abc import Sequence
from pathlib import Path

from google.protobuf import json_format

from flair import v1
from programs import SOURCE, Program, example, flair


class Contract(unittest.TestCase):
    def keeps(self, stage: str, server: Program) -> None:
        with tempfile.TemporaryDirectory() as home, server:
            # Other tests run beside this one: slow is not broken.
            result = flair("contract", stage, "--target", server.address, "--patience", "120", home=Path(home))
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertNotIn("Traceback", server.errors())

    def test_the_optimizer_keeps_the_contract(self) -> None:
        self.keeps("optimizer", example("python_optimizer"))

    def test_the_language_worker_keeps_the_contract(self) -> None:
        self.keeps("language", example("python_language"))


class Design(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def design(self, text: str, *more: str, out: str = "out") -> Path:
        """The folder of a design; the command must succeed."""
        result = flair("design", text, "--out", self.folder / out, *more, home=self.folder / f"home_{out}")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return self.folder / out

    def layout(self, folder: Path) -> v1.SolvedLayout:
        return v1.Artifact.FromString((folder / "layout.pb").read_bytes()).solved_layout

    def assert_good_plan(self, folder: Path) -> None:
        layout = self.layout(folder)
        self.assertEqual(len(layout.placements), len(layout.graph.object_list.objects))
        self.assertLess(layout.metrics.oob_percent + layout.metrics.oor_percent, 1e-6)
        picture = (folder / "plan.png").read_bytes()
        self.assertEqual(picture[:4], b"\x89PNG")
        self.assertGreater(len(picture), 50_000)

    def test_a_design_through_the_optimizer_ends_in_a_plan(self) -> None:
        server = self.enterContext(example("python_optimizer"))
        out = self.design("A bedroom that is 4m x 5m.", "--optimizer", server.address)
        self.assert_good_plan(out)
        layout = self.layout(out)
        self.assertEqual(layout.graph.catalog_library, "python-optimizer 1")
        self.assertEqual({edge.type for edge in layout.graph.edges}, {"against_wall", "next_to"})
        self.assertEqual({outcome.status for outcome in layout.edge_outcomes},
                         {v1.OutcomeStatus.OUTCOME_STATUS_SATISFIED})

    def test_the_same_design_again_gives_the_same_bytes(self) -> None:
        layouts = []
        for out in ("first", "second"):
            with example("python_optimizer") as server:  # another process, another port
                folder = self.design("A home office.", "--optimizer", server.address, "--seed", "2", out=out)
            layouts.append((folder / "layout.pb").read_bytes())
        self.assertEqual(*layouts)

    def test_a_design_through_the_language_worker_is_the_room_of_the_folder(self) -> None:
        server = self.enterContext(example("python_language"))
        out = self.design("A music room.", "--language", server.address)
        self.assert_good_plan(out)
        wanted = (SOURCE / "examples/python_language/rooms/music_room/objects.json").read_text()
        self.assertEqual(self.layout(out).graph.object_list, json_format.Parse(wanted, v1.ObjectList()))
        self.assertEqual(untranslated(self.layout(out).graph), [])

    def test_both_together_end_in_a_plan(self) -> None:
        servers = [self.enterContext(example(name)) for name in ("python_language", "python_optimizer")]
        out = self.design("A bedroom.", "--language", servers[0].address, "--optimizer", servers[1].address)
        self.assert_good_plan(out)

    def test_a_brief_that_names_no_room_of_the_folder_says_which_there_are(self) -> None:
        server = self.enterContext(example("python_language"))
        result = flair("design", "A spaceship.", "--language", server.address, "--out", self.folder / "out",
                       home=self.folder / "home")
        self.assertNotEqual(result.returncode, 0)
        self.assertRegex(result.stderr, re.escape('brief.text: "A spaceship." names none of the rooms here: "bedroom"'))
        self.assertFalse((self.folder / "out").exists())


class Starting(unittest.TestCase):
    def test_an_address_in_use_is_said(self) -> None:
        for name in ("python_optimizer", "python_language"):
            with example(name) as server, self.assertRaisesRegex(AssertionError, "cannot listen on 127.0.0.1"):
                example(name, "--listen", server.address).__enter__()

    def test_a_folder_without_rooms_is_said(self) -> None:
        with tempfile.TemporaryDirectory() as empty, self.assertRaisesRegex(AssertionError, "no rooms"):
            example("python_language", "--rooms", empty).__enter__()

    def test_sigterm_ends_a_server_in_peace(self) -> None:
        server = example("python_optimizer")
        with server:
            server.process.terminate()
            self.assertEqual(server.process.wait(timeout=60), 0)


def untranslated(graph: v1.LayoutGraph) -> Sequence[str]:
    """Sentences of which no call was made."""
    translated = {edge.sentence_id for edge in graph.edges}
    return [sentence.text for sentence in graph.constraint_list.sentences if sentence.id not in translated]


if __name__ == "__main__":
    unittest.main()
