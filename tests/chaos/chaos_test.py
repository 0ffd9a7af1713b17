# SPDX-License-Identifier: GPL-3.0-or-later
"""A short form of tests/chaos/run for every build: two kinds of queue, every kind of server killed and frozen."""

import os
import subprocess
import sys
import unittest
from pathlib import Path

RUN = Path(__file__).parent / "run"


class Chaos(unittest.TestCase):
    def stands(self, *arguments: str) -> None:
        build = Path(os.environ["FLAIR_BIN"]).parent if "FLAIR_BIN" in os.environ else None
        where = ["--build", str(build)] if build else []
        run = subprocess.run([sys.executable, RUN, *where, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertRegex(run.stdout, r"\d+ artifacts compared: all right")

    def test_jobs_in_a_folder_end_once_and_as_ever(self) -> None:
        self.stands("--jobs", "40", "--engine", "sqlite", "--fault-every", "2", "--longest", "1")

    def test_jobs_in_nats_end_once_and_as_ever(self) -> None:
        self.stands("--jobs", "40", "--engine", "jetstream", "--fault-every", "2", "--longest", "1")


if __name__ == "__main__":
    unittest.main()
