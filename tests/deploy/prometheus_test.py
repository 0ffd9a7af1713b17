# SPDX-License-Identifier: GPL-3.0-or-later
"""deploy/prometheus with Prometheus' own promtool: the files are good, and the alerts fire when they should."""

import shutil
import subprocess
import unittest

from deployment_files import ROOT

PROMTOOL = shutil.which("promtool")


@unittest.skipUnless(PROMTOOL, "needs promtool: apt-get install prometheus")
class Prometheus(unittest.TestCase):
    def check(self, *arguments):
        run = subprocess.run([PROMTOOL, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_configs_and_rules_are_good(self):
        self.check("check", "config", ROOT / "deploy/prometheus/prometheus.yml")
        self.check("check", "config", ROOT / "deploy/compose/prometheus.yml")
        self.check("check", "rules", ROOT / "deploy/prometheus/alerts.yml")

    def test_alerts_fire_when_they_should_and_only_then(self):
        self.check("test", "rules", ROOT / "tests/deploy/alerts_test.yml")


if __name__ == "__main__":
    unittest.main()
