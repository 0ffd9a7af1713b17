# SPDX-License-Identifier: GPL-3.0-or-later
"""The package as people get it: installed by pip without a network, or made by its script; the README's quick start."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from programs import SOURCE, orchestrator, program

CLIENT = SOURCE / "clients" / "python"


def run(*command: str | Path, folder: Path, **environment: str) -> str:
    """What a command prints; it must succeed. Knows nothing of the package of the build."""
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    result = subprocess.run([str(part) for part in command], cwd=folder, env={**clean, **environment},
                            capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{command}: {result.stdout}{result.stderr}")
    return result.stdout


class Package(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_pip_installs_it_offline_and_the_quick_start_of_its_readme_runs(self) -> None:
        environment = self.folder / "venv"
        run(sys.executable, "-m", "venv", "--system-site-packages", environment, folder=self.folder)
        # PIP_NO_INDEX proves that the README's very command needs no network.
        run(environment / "bin/pip", "install", CLIENT, folder=self.folder, PIP_NO_INDEX="1")
        stages = {name: self.enterContext(program(f"flair-{name}", self.folder)).address
                  for name in ("language", "translator", "optimizer", "renderer")}
        server = self.enterContext(orchestrator(self.folder, **stages))
        blocks = re.findall(r"```python\n(.*?)```", (CLIENT / "README.md").read_text(), re.DOTALL)
        # The second, of edits and batches, needs workers' addresses; client_test.py makes its calls.
        self.assertEqual(len(blocks), 2)
        compile(blocks[1], "README.md", "exec")
        self.assertIn('"127.0.0.1:50050"', blocks[0])
        (self.folder / "quick_start.py").write_text(blocks[0].replace("127.0.0.1:50050", server.address))
        said = run(environment / "bin/python", "quick_start.py", folder=self.folder)
        self.assertIn("room stage_finished bedroom, 4 m x 5 m", said)
        self.assertIn("objects placed", said)
        self.assertEqual((self.folder / "plan.png").read_bytes()[:4], b"\x89PNG")

    def test_the_script_makes_it_without_a_build(self) -> None:
        run(sys.executable, CLIENT / "generate.py", self.folder / "made", folder=self.folder)
        code = "import flair, flair.stage; print(flair.v1.Room.__name__, flair.__file__)"
        said = run(sys.executable, "-c", code, folder=self.folder, PYTHONPATH=str(self.folder / "made"))
        self.assertEqual(said, f"Room {self.folder / 'made/flair/__init__.py'}\n")

    def test_the_same_sources_give_the_same_wheel(self) -> None:
        code = "import sys; sys.path.insert(0, sys.argv[1]); import build_backend as b; print(b.build_wheel('.'))"
        wheels = []
        for name in ("first", "second"):
            (folder := self.folder / name).mkdir()
            wheel = run(sys.executable, "-c", code, CLIENT, folder=folder).strip()
            wheels.append((folder / wheel).read_bytes())
        self.assertEqual(*wheels)


if __name__ == "__main__":
    unittest.main()
