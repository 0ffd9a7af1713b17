# SPDX-License-Identifier: GPL-3.0-or-later
"""The configs that containers mount, with the real programs: mutual TLS everywhere, NATS with storage, tokens."""

import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from deployment_files import ROOT
from local_cluster import Cluster


class ContainerConfigs(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory(prefix="flair-deploy-")
        cls.addClassCleanup(folder.cleanup)
        cls.cluster = Cluster(Path(folder.name))
        cls.addClassCleanup(cls.cluster.stop)
        cls.cluster.start()

    def test_a_client_with_certificate_and_token_designs_a_room(self) -> None:
        out = self.cluster.folder / "bedroom"
        run = self.cluster.client("design", "A bedroom that is 3m x 4m.", "--out", str(out), "--quiet", "--orchestrator",
                                  self.cluster.addresses["orchestrator"])
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue((out / "plan.png").exists())

    def test_probes_of_every_program_find_it_well(self) -> None:
        for name, address in self.cluster.addresses.items():
            if name != "nats-0.nats":
                run = self.cluster.client("health", address, secrets=name, token=False)
                self.assertEqual(run.returncode, 0, f"{name}: {run.stderr}")

    def test_no_token_and_strangers_are_refused(self) -> None:
        orchestrator = self.cluster.addresses["orchestrator"]
        run = self.cluster.client("jobs", "--orchestrator", orchestrator, token=False)
        self.assertNotEqual(run.returncode, 0)
        with tempfile.TemporaryDirectory() as others:
            subprocess.run([ROOT / "deploy/secrets/make", others], check=True, stdout=subprocess.DEVNULL)
            strange = self.cluster.folder / "secrets/stranger"
            shutil.copytree(Path(others) / "client", strange)
            shutil.copy(self.cluster.folder / "secrets/client/authority.pem", strange)
            for address in (orchestrator, self.cluster.addresses["optimizer"]):
                self.assertNotEqual(self.cluster.client("health", address, secrets="stranger").returncode, 0)


if __name__ == "__main__":
    unittest.main()
