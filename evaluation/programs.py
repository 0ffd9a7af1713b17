# SPDX-License-Identifier: GPL-3.0-or-later
"""Our programs as scripts run them, and files with the words and exit codes that our programs have for them."""

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

BIN = Path(os.environ.get("FLAIR_BIN", Path(__file__).resolve().parents[1] / "build/release/bin"))
BAD_INPUT, BAD_FILE = 2, 4


class Refused(Exception):
    """Nothing was done; says why."""

    def __init__(self, why: str, exit_code: int = BAD_INPUT) -> None:
        super().__init__(why)
        self.exit_code = exit_code


def flair(*arguments: object, home: Path | None = None) -> None:
    """Runs bin/flair; with `home` in a $FLAIR_HOME of its own, without what else the user's environment says."""
    environment = dict(os.environ)
    if home is not None:
        environment = {name: value for name, value in environment.items() if not name.startswith("FLAIR_")}
        environment["FLAIR_HOME"] = str(home)
    command = [str(BIN / "flair"), *map(str, arguments)]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise Refused(ended.stderr.strip().removeprefix("flair: "), ended.returncode)


def read_file(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except IsADirectoryError as error:
        raise Refused(f"{path}: is a folder", BAD_FILE) from error
    except FileNotFoundError as error:
        raise Refused(f"{path}: no such file") from error
    except OSError as error:
        raise Refused(f"{path}: {error.strerror}", BAD_FILE) from error


def check_output(path: Path) -> None:
    """That a file can be written there."""
    if path.is_dir():
        raise Refused(f"{path}: is a folder", BAD_FILE)
    if not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
        raise Refused(f"{path}: cannot be written", BAD_FILE)


def read_artifact(path: Path) -> dict:
    """An artifact in the form of its JSON, whatever form the file has."""
    with tempfile.TemporaryDirectory(prefix="flair-artifact-") as scratch:
        text = Path(scratch) / "artifact.json"
        flair("inspect", path, "--out", text)
        return json.loads(text.read_text(encoding="utf-8"))


def write_artifact(artifact: dict, out: Path) -> None:
    """The extension chooses the form; what is no valid artifact is refused."""
    with tempfile.TemporaryDirectory(prefix="flair-artifact-") as scratch:
        text = Path(scratch) / "artifact.json"
        text.write_text(json.dumps(artifact), encoding="utf-8")
        try:
            flair("inspect", text, "--out", out)
        except Refused as error:
            raise Refused(str(error).removeprefix(f"{text}").lstrip(":0123456789 ")) from error


def counted(count: int, thing: str) -> str:
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def run(main: Callable[[], None]) -> None:
    """Ends the program with what `main` comes to."""
    try:
        main()
    except Refused as error:
        print(f"flair-dev: {error}", file=sys.stderr)
        sys.exit(error.exit_code)
