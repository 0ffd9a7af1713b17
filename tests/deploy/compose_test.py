# SPDX-License-Identifier: GPL-3.0-or-later
"""compose.yaml and the files beside it: names, ports, mounts and secrets fit together."""

import re
import unittest

from deployment_files import ROOT, Config, load_all, secret_names, service_of

SERVICES = load_all(ROOT / "compose.yaml")[0]["services"]
HEALTH = load_all(ROOT / "deploy/compose/health.yaml")[0]["services"]
OTHERS = sorted((ROOT / "deploy/compose").glob("*.yaml"))


def mounts(service):
    """Source by target, with the defaults of variables."""
    plain = (re.sub(r"\$\{\w+:-([^}]*)\}", r"\1", volume) for volume in service.get("volumes", []))
    return {target: source for source, target in (volume.split(":")[:2] for volume in plain)}


def config_of(service):
    for target, source in mounts(service).items():
        if target.startswith("/etc/"):
            return Config(ROOT / source)
    return None


def secret_of(service):
    return mounts(service).get("/run/secrets/flair", "").removeprefix("./out/secrets/")


class Compose(unittest.TestCase):
    def test_every_mounted_file_is_there(self):
        for name, service in SERVICES.items():
            for source in mounts(service).values():
                if source.startswith("./") and not source.startswith("./out/"):
                    self.assertTrue((ROOT / source).exists(), f"{name} mounts {source}")

    def test_whoever_is_called_listens_there_and_can_be_reached(self):
        calls = 0
        for name, service in SERVICES.items():
            config = config_of(service)
            for callee, port in config.calls() if config else []:
                self.assertIn(callee, SERVICES, f"{name} calls it")
                self.assertEqual(config_of(SERVICES[callee]).port, port, f"{name} calls {callee}")
                self.assertTrue(set(service["networks"]) & set(SERVICES[callee]["networks"]), f"{name} calls {callee}")
                calls += 1
        self.assertGreaterEqual(calls, 8)

    def test_certificates_name_the_service_that_shows_them(self):
        for name, service in SERVICES.items():
            if config := config_of(service):
                self.assertTrue(config.is_mutual_tls(), name)
                self.assertIn(secret_of(service), secret_names(), name)
                # `orchestrators` is called by nobody; nats-0.nats is below nats.
                own = name.split(".")[-1]
                self.assertTrue(own.startswith(secret_of(service)), name)

    def test_every_program_asks_itself(self):
        for name, service in SERVICES.items():
            program = service["command"][0]
            if not program.startswith("flair-"):
                continue
            test = HEALTH[name]["healthcheck"]["test"]
            self.assertEqual(test[:3], ["CMD", "flair", "health"], name)
            self.assertEqual(test[3], f"127.0.0.1:{config_of(service).port}", name)
            self.assertEqual(test[4], f"--service={service_of(program)}", name)

    def test_nothing_runs_with_more_rights_than_it_needs(self):
        services = dict(SERVICES)
        for path in OTHERS:
            if path.name == "health.yaml":
                continue
            services.update(load_all(path)[0]["services"])
        for name, service in services.items():
            self.assertEqual(service.get("cap_drop"), ["ALL"], name)
            self.assertTrue(service.get("read_only"), name)
            if name != "secrets":
                self.assertNotIn("cap_add", service, name)
                self.assertNotIn("user", service, name)
                self.assertIn("no-new-privileges:true", service["security_opt"], name)
                self.assertIn("memory", service["deploy"]["resources"]["limits"], name)

    def test_images_run_as_somebody_else_than_root(self):
        for path in ("Containerfile", "deploy/compose/Containerfile"):
            self.assertIn("\nUSER 10001:10001\n", (ROOT / path).read_text(encoding="utf-8"), path)


if __name__ == "__main__":
    unittest.main()
