# SPDX-License-Identifier: GPL-3.0-or-later
"""Real programs on free ports, for tests: ours from FLAIR_BIN, the examples from the source tree."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BIN = Path(os.environ["FLAIR_BIN"])


class Program:
    """A server as a child process, ended with the `with` block. Its address is known when it has been entered."""

    def __init__(self, *command: str | Path) -> None:
        self._command = [str(part) for part in command]
        self._errors = tempfile.TemporaryFile("w+")

    def __enter__(self) -> "Program":
        self.process = subprocess.Popen(self._command, stdout=subprocess.PIPE, stderr=self._errors, text=True)
        for line in self.process.stdout:
            if line.startswith("listening on "):
                self.address = line.removeprefix("listening on ").strip()
                return self
        reason = self.errors()
        self.__exit__()
        raise AssertionError(f"{self._command[0]} did not start: {reason}")

    def __exit__(self, *_: object) -> None:
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()
        self._errors.close()

    def errors(self) -> str:
        """What it has written to standard error so far."""
        self._errors.seek(0)
        return self._errors.read()


def example(name: str, *arguments: str | Path) -> Program:
    """One of the stages of examples/."""
    return Program(sys.executable, SOURCE / "examples" / name / "main.py", "--listen", "127.0.0.1:0", *arguments)


def program(name: str, folder: Path, config: str = "") -> Program:
    """bin/NAME with a config."""
    path = folder / f"{name}.textproto"
    path.write_text(f'runtime {{ listen_address: "127.0.0.1:0" log_level: "error" }}\n{config}\n')
    return Program(BIN / name, path)


def orchestrator(folder: Path, **stages: str) -> Program:
    """flair-orchestrator over stages given by address: language, translator, optimizer, renderer."""
    addresses = " ".join(f'{name}: "{address}"' for name, address in stages.items())
    return program("flair-orchestrator", folder, f'store_path: "{folder / "store"}"\nstages {{ {addresses} }}')


def flair(*arguments: str | Path, home: Path) -> subprocess.CompletedProcess[str]:
    """Runs the command line program to its end."""
    environment = {**os.environ, "FLAIR_HOME": str(home)}
    command = [str(part) for part in (BIN / "flair", *arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
