# SPDX-License-Identifier: GPL-3.0-or-later
"""Recorded problems of the paper's authors as graphs, by way of our programs."""

import json
import subprocess
import tempfile
from pathlib import Path


class BadProblem(Exception):
    """A file that is no recorded problem; says where and why."""


def read_graph(programs: Path, path: Path) -> dict:
    """The layout graph that `flair-dev import flairgpt` makes of the file; `programs` is the folder of flair and flair-dev."""
    with tempfile.TemporaryDirectory(prefix="flair-graph-") as scratch:
        graph = Path(scratch) / "graph.pb"
        for command in ([programs / "flair-dev", "import", "flairgpt", path, "--out", graph],
                        [programs / "flair", "inspect", graph, "--out", graph.with_suffix(".json")]):
            ended = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
            if ended.returncode != 0:
                raise BadProblem(ended.stderr.strip().splitlines()[-1].removeprefix("flair-dev: ").removeprefix("flair: "))
        return json.loads(graph.with_suffix(".json").read_text(encoding="utf-8"))["layout_graph"]
