# SPDX-License-Identifier: GPL-3.0-or-later
"""Designs all briefs of an exam with one `flair batch`, in a $FLAIR_HOME of its own."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from plan import Plan, read_plan
from wishes import Brief


class NoDesigns(Exception):
    """The program did not get as far as a batch."""


def _write_batch(briefs: list[Brief], path: Path) -> None:
    path.write_text("".join(json.dumps({"text": brief.text}) + "\n" for brief in briefs), encoding="utf-8")


def design_all(flair: Path, briefs: list[Brief], out: Path, jobs: int, picture_px: int) -> None:
    """Fills `out`; what the program says of its progress goes to standard error."""
    with tempfile.TemporaryDirectory(prefix="flair-briefs-") as scratch:
        lines = Path(scratch) / "briefs.jsonl"
        _write_batch(briefs, lines)
        # The handbook alone: a model that the user's environment names is none of this exam's business.
        environment = {name: value for name, value in os.environ.items() if name != "FLAIR_LLM"}
        environment["FLAIR_HOME"] = str(Path(scratch) / "home")
        command = [flair, "batch", lines, "--out", out, "--keep", "layout.json,report.json,pictures", "--parallel",
                   str(jobs), "--size", str(picture_px)]
        try:
            ended = subprocess.run([str(part) for part in command], env=environment, stdout=sys.stderr, check=False)
        except OSError as error:
            raise NoDesigns(f"{flair}: {error.strerror}") from error
    if ended.returncode != 0 and not (out / "jobs").is_dir():
        raise NoDesigns(f"{flair} batch ended with {ended.returncode} and no designs; above it says why")


def _folder(out: Path, index: int) -> Path:
    return out / "jobs" / f"{index // 1000:03}" / f"{index:06}"


def plans(briefs: list[Brief], out: Path) -> list[Plan | None]:
    """In the order of the briefs; None for a design that failed."""
    found = []
    for index in range(len(briefs)):
        layout, report = _folder(out, index) / "layout.json", _folder(out, index) / "report.json"
        found.append(read_plan(layout, report) if layout.is_file() and report.is_file() else None)
    return found
