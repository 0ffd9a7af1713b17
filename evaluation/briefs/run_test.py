# SPDX-License-Identifier: GPL-3.0-or-later
"""The command with the real program: what 25 briefs come to, and what it says when it cannot run."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

RUN = Path(__file__).parent / "run"
FLAIR = Path(os.environ["FLAIR_BIN"]) / "flair"


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(RUN), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Designs(unittest.TestCase):
    def test_the_handbook_obeys_as_many_wishes_as_it_did(self) -> None:
        """Measured: 44 obeyed and 5 silent of 53. A wish or two may come and go with a layout."""
        ended = run("--flair", FLAIR, "--first", 25, "--at-least-obeyed", 42, "--at-most-silent", 7)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertRegex(ended.stdout, r"set development: 25 briefs, \d+ wishes")

    def test_demands_that_are_not_met_end_with_1(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        wish = '{"wish": "%s", "check": "count", "of": "%s", "exactly": 1, "remark": ["%s"]}'
        wishes = ", ".join(wish % (name, name, name) for name in ("desk", "trapeze"))
        (folder / "mine.jsonl").write_text('{"set": "mine", "misses": "hidden"}\n'
                                           f'{{"id": "a", "brief": "A study with a desk.", "wishes": [{wishes}]}}\n')
        mine = ("--flair", FLAIR, "--file", folder / "mine.jsonl")
        ended = run(*mine, "--out", folder / "out", "--at-least-obeyed", 2, "--at-most-silent", 0)
        self.assertEqual(ended.returncode, 1, ended.stdout + ended.stderr)
        self.assertIn("run: 1 wishes are obeyed; at least 2 are demanded", ended.stderr)
        self.assertIn("run: 1 wishes are lost without a word; at most 0 are allowed", ended.stderr)
        self.assertIn("This set hides its misses; --show-misses lists them.", ended.stdout)
        self.assertNotIn("trapeze", ended.stdout)
        self.assertTrue((folder / "out/jobs/000/000000/plan.png").is_file())
        again = run(*mine, "--out", folder / "out")
        self.assertEqual(again.returncode, 2)
        self.assertIn("is no empty folder; a new one would be right", again.stderr)
        shown = run(*mine, "--show-misses")
        self.assertEqual(shown.returncode, 0, shown.stderr)
        self.assertIn("trapeze (count)", shown.stdout)


class BadCalls(unittest.TestCase):
    def test_what_cannot_run_says_why(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        cases = [(("--flair", folder / "none"), "--flair: .*none is no file; ./flair build"),
                 (("--flair", FLAIR, "--file", folder / "none.jsonl"), "none.jsonl.*No such file"),
                 (("--jobs", "0"), "--jobs: is '0'; a whole number from 1 would be right")]
        for arguments, said in cases:
            with self.subTest(said):
                ended = run(*arguments)
                self.assertEqual(ended.returncode, 2)
                self.assertTrue(re.search(said, ended.stderr), ended.stderr)
                self.assertNotIn("Traceback", ended.stderr)


if __name__ == "__main__":
    unittest.main()
