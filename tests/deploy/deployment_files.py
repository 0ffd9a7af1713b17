# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of a deployment as the tests read them."""

import pathlib
import re

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
KUBERNETES = ROOT / "deploy" / "kubernetes"


def load_all(path):
    """The YAML documents of a file."""
    with open(path, encoding="utf-8") as file:
        return [document for document in yaml.safe_load_all(file) if document]


class Config:
    """What the test needs of a program's text proto or of a NATS config."""

    def __init__(self, path):
        self.text = re.sub(r"(?m)^\s*#.*$", "", path.read_text(encoding="utf-8"))
        listen = re.search(r'listen_address: "0\.0\.0\.0:(\d+)"', self.text) or re.search(r"(?m)^port: (\d+)", self.text)
        self.port = int(listen.group(1))
        metrics = re.search(r'metrics_address: "0\.0\.0\.0:(\d+)"', self.text)
        self.metrics_port = int(metrics.group(1)) if metrics else None

    def calls(self):
        """Names and ports of whom the program calls."""
        named = re.findall(r"(?:dns:///|tls://|nats://)([a-z0-9.-]+):(\d+)", self.text)
        return sorted({(name, int(port)) for name, port in named})

    def is_mutual_tls(self):
        return "require_client_certificate: true" in self.text or "verify: true" in self.text

    def secrets(self):
        """Files of /run/secrets/flair."""
        return set(re.findall(r'"/run/secrets/flair/([a-z_.]+)"', self.text))


def secret_names():
    """Who deploy/secrets/make makes certificates for."""
    script = (ROOT / "deploy/secrets/make").read_text(encoding="utf-8")
    return set(re.search(r"(?m)^programs=\((.*)\)", script).group(1).split()) | {"client"}


def service_of(program):
    """The gRPC service of a program: flair-language serves flair.v1.LanguageService."""
    return f"flair.v1.{program.removeprefix('flair-').capitalize()}Service"
