# SPDX-License-Identifier: GPL-3.0-or-later
"""deploy/kubernetes: every reference between its files, and to the configs, leads somewhere."""

import re
import subprocess
import unittest

from deployment_files import KUBERNETES, ROOT, Config, load_all, secret_names, service_of

BASE = KUBERNETES / "base"


def by_kind(folder):
    """The objects of a folder's files, by kind."""
    kinds = {}
    for path in sorted(folder.glob("*.yaml")):
        if path.name not in ("kustomization.yaml", "hardened.yaml"):
            for document in load_all(path):
                kinds.setdefault(document["kind"], []).append(document)
    return kinds


def fits(selector, labels):
    return all(labels.get(key) == value for key, value in selector.items())


OBJECTS = by_kind(BASE)
WORKLOADS = {item["metadata"]["name"]: item for item in OBJECTS["Deployment"] + OBJECTS["StatefulSet"]}
SERVICES = {item["metadata"]["name"]: item for item in OBJECTS["Service"]}


def pod_of(name):
    return WORKLOADS[name]["spec"]["template"]


def container_of(name):
    return pod_of(name)["spec"]["containers"][0]


def volume_of(name, volume):
    return next(item for item in pod_of(name)["spec"]["volumes"] if item["name"] == volume)


def config_of(name):
    """The config that a workload's config map is made from."""
    maps = {item["name"]: item["files"][0].split("=")[-1]
            for item in load_all(ROOT / "deploy/config/kustomization.yaml")[0]["configMapGenerator"]}
    return Config(ROOT / "deploy/config" / maps[volume_of(name, "config")["configMap"]["name"]])


class Kubernetes(unittest.TestCase):
    def test_every_file_is_used_and_every_used_file_is_there(self):
        for path in list(KUBERNETES.rglob("kustomization.yaml")) + list((ROOT / "deploy/config").rglob("kustomization.yaml")):
            kustomization = load_all(path)[0]
            used = kustomization.get("resources", []) + kustomization.get("components", [])
            used += [patch["path"] for patch in kustomization.get("patches", []) if "path" in patch]
            for maker in kustomization.get("configMapGenerator", []):
                used += [file.split("=")[-1] for file in maker["files"]]
            for name in used:
                self.assertTrue((path.parent / name).exists(), f"{path}: {name}")
            there = {file.name for file in path.parent.glob("*.*")} - {"kustomization.yaml"}
            self.assertEqual(there - set(used), set(), path)

    def test_nobody_else_says_how_many_there_are_of_what_is_scaled(self):
        folder = KUBERNETES / "components/autoscaling"
        scaled = {item["spec"]["scaleTargetRef"]["name"] for item in load_all(folder / "scaled_objects.yaml")}
        self.assertLessEqual(scaled, WORKLOADS.keys())
        patch = load_all(folder / "kustomization.yaml")[0]["patches"][0]
        self.assertIn("remove, path: /spec/replicas", patch["patch"])
        self.assertEqual(set(patch["target"]["name"].split("|")), scaled)

    def test_pods_listen_where_services_and_probes_look(self):
        for name, workload in WORKLOADS.items():
            container, config = container_of(name), config_of(name)
            ports = {port["name"]: port["containerPort"] for port in container["ports"]}
            self.assertIn(config.port, ports.values(), name)
            self.assertEqual(ports.get("metrics"), config.metrics_port, name)
            service = SERVICES[name]
            self.assertTrue(fits(service["spec"]["selector"], pod_of(name)["metadata"]["labels"]), name)
            for port in service["spec"]["ports"]:
                self.assertEqual(port["port"], ports[port["targetPort"]], name)
            self.assertEqual(workload["spec"]["selector"]["matchLabels"], pod_of(name)["metadata"]["labels"], name)
            for probe in ("startupProbe", "readinessProbe", "livenessProbe"):
                if name == "nats":
                    self.assertIn(container[probe]["httpGet"]["port"], ports)
                    continue
                command = container[probe]["exec"]["command"]
                self.assertEqual(command[:3], ["flair", "health", f"127.0.0.1:{config.port}"], name)
                self.assertEqual(command[3], f"--service={service_of(container['command'][0])}", name)

    def test_pods_have_certificates_of_their_names_and_a_budget(self):
        budgets = [item["spec"]["selector"]["matchLabels"] for item in OBJECTS["PodDisruptionBudget"]]
        for name in WORKLOADS:
            self.assertTrue(config_of(name).is_mutual_tls(), name)
            self.assertEqual(volume_of(name, "secrets")["secret"]["secretName"], f"flair-{name}")
            self.assertIn(name, secret_names())
            self.assertEqual(sum(fits(budget, pod_of(name)["metadata"]["labels"]) for budget in budgets), 1, name)

    def test_network_policies_allow_what_configs_call_and_nothing_else(self):
        # nats-0.nats is a pod of the service nats.
        called = {(callee.split(".")[-1], port, name) for name in WORKLOADS for callee, port in config_of(name).calls()}
        called |= {("nats", port, "nats") for _, port in Config(ROOT / "deploy/config/three_node/nats.conf").calls()}
        allowed = set()
        for policy in OBJECTS["NetworkPolicy"]:
            spec = policy["spec"]
            for rule in spec.get("ingress", []):
                for caller in rule["from"]:
                    if "namespaceSelector" not in caller:
                        allowed |= {(spec["podSelector"]["matchLabels"]["app.kubernetes.io/name"], port["port"],
                                     caller["podSelector"]["matchLabels"]["app.kubernetes.io/name"])
                                    for port in rule["ports"]}
        self.assertEqual(allowed, called)

    def test_three_nodes_are_called_by_names_that_the_stateful_set_gives(self):
        for file in ("nats.conf", "orchestrator.textproto"):
            text = (ROOT / "deploy/config/three_node" / file).read_text(encoding="utf-8")
            self.assertEqual(set(re.findall(r"//(nats-[0-9.a-z]+)", text)), {"nats-0.nats", "nats-1.nats", "nats-2.nats"})
        self.assertIn("replica_count: 3", text)
        self.assertIn({"name": "nats", "count": 3}, load_all(KUBERNETES / "three_node/kustomization.yaml")[0]["replicas"])

    def test_configs_for_three_nodes_differ_in_nothing_else(self):
        one = (ROOT / "deploy/config/orchestrator.textproto").read_text(encoding="utf-8").splitlines()
        three = (ROOT / "deploy/config/three_node/orchestrator.textproto").read_text(encoding="utf-8").splitlines()
        differing = [ours for ours, theirs in zip(three[1:], one[1:], strict=True) if ours != theirs]
        self.assertEqual([line.split(":")[0].strip() for line in differing], ["address", "replica_count"])

    def test_what_is_scaled_is_there_and_so_is_the_figure_that_decides(self):
        programs = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "orchestrator").rglob("*.cc"))
        for item in by_kind(KUBERNETES / "components/autoscaling")["ScaledObject"]:
            self.assertIn(item["spec"]["scaleTargetRef"]["name"], WORKLOADS)
            figure = re.search(r"flair_[a-z_]+", item["spec"]["triggers"][0]["metadata"]["query"]).group(0)
            self.assertTrue(f'"{figure}"' in programs, f"no orchestrator tells {figure}")

    def test_pods_have_the_least_rights_that_do(self):
        hardened = load_all(BASE / "hardened.yaml")[0]["spec"]["template"]["spec"]
        job = by_kind(KUBERNETES / "components/batch")["Job"][0]["spec"]["template"]["spec"]
        for spec in (hardened, job, pod_of("nats")["spec"]):
            self.assertFalse(spec["automountServiceAccountToken"])
            self.assertTrue(spec["securityContext"]["runAsNonRoot"])
            self.assertEqual(spec["securityContext"]["seccompProfile"], {"type": "RuntimeDefault"})
            rights = spec["containers"][0]["securityContext"]
            self.assertTrue(rights["readOnlyRootFilesystem"])
            self.assertFalse(rights["allowPrivilegeEscalation"])
            self.assertEqual(rights["capabilities"], {"drop": ["ALL"]})
        for name in WORKLOADS:
            self.assertEqual(container_of(name)["name"], "nats" if name == "nats" else "flair")  # merged by name


if __name__ == "__main__":
    unittest.main()
