# SPDX-License-Identifier: GPL-3.0-or-later
"""deploy/kubernetes, as kustomize builds it, against the schemas of its kinds; see schemas/run."""

import shutil
import subprocess
import unittest

from deployment_files import ROOT


@unittest.skipUnless(shutil.which("kubectl") and shutil.which("npm"), "needs kubectl, node and npm")
class Schemas(unittest.TestCase):
    def test_every_object_of_every_form_is_as_its_kind_says(self):
        run = subprocess.run([ROOT / "tests/deploy/schemas/run"], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        for form in ("small", "three_node", "components"):
            self.assertRegex(run.stdout, rf"(?m)^{form}: [1-9][0-9]* objects, 0 wrong$")


if __name__ == "__main__":
    unittest.main()
