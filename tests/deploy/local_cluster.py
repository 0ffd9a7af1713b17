# SPDX-License-Identifier: GPL-3.0-or-later
"""The configs that containers mount, with the real programs, as processes of this machine."""

import os
import re
import shutil
import subprocess
import threading
from pathlib import Path

from deployment_files import ROOT

BIN = Path(os.environ["FLAIR_BIN"])
NATS = shutil.which("nats-server", path=f"{os.environ.get('PATH', '')}:/usr/sbin")
CONFIGS = ROOT / "deploy/config"


class Cluster:
    """What compose.yaml starts, as processes of this machine on free ports; the configs are changed in nothing else."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.addresses: dict[str, str] = {}
        # Where the programs serve their figures.
        self.metrics: dict[str, str] = {}
        self._processes: list[subprocess.Popen] = []
        self._readers: list[threading.Thread] = []

    def start(self) -> None:
        subprocess.run([ROOT / "deploy/secrets/make", self.folder / "secrets"], check=True, stdout=subprocess.DEVNULL)
        self._start_nats()
        for name, program in (("language", "language"), ("restarts", "optimizer"), ("optimizer", "optimizer"),
                              ("translator", "translator"), ("renderer", "renderer"), ("orchestrator", "orchestrator")):
            self._start(name, program)

    def stop(self) -> None:
        for process in reversed(self._processes):
            process.terminate()
        for reader in self._readers:
            reader.join()
        for process in self._processes:
            process.wait()
            for pipe in filter(None, (process.stdout, process.stderr)):
                pipe.close()

    def client(self, *arguments: str, secrets: str = "client", token: bool = True) -> subprocess.CompletedProcess[str]:
        """`flair` as the README calls it, with the secrets of somebody."""
        own = self.folder / "secrets" / secrets
        environment = {**os.environ, "FLAIR_HOME": str(self.folder / "home"), "FLAIR_TLS_AUTHORITY": f"{own}/authority.pem",
                       "FLAIR_TLS_CERTIFICATE": f"{own}/certificate.pem", "FLAIR_TLS_KEY": f"{own}/key.pem"}
        if token:
            environment["FLAIR_TOKEN_FILE"] = f"{own}/token"
        return subprocess.run([BIN / "flair", *arguments], env=environment, capture_output=True, text=True, check=False)

    def _config(self, name: str, file: str) -> str:
        text = (CONFIGS / file).read_text(encoding="utf-8")
        text = text.replace("/run/secrets/flair/", f"{self.folder}/secrets/{name}/")
        text = re.sub(r'"0\.0\.0\.0:\d+"', '"127.0.0.1:0"', text)
        text = text.replace("/var/lib/flair", str(self.folder / name))
        return re.sub(r"(?:dns:///|(tls://))([a-z]+|nats-0\.nats):\d+", lambda call: (call[1] or "") + self.addresses[call[2]], text)

    def _start(self, name: str, program: str) -> None:
        path = self.folder / f"{name}.textproto"
        path.write_text(self._config(name, f"{name}.textproto"), encoding="utf-8")
        with open(self.folder / f"{name}.log", "w", encoding="utf-8") as log:
            process = subprocess.Popen([BIN / f"flair-{program}", path], stdout=subprocess.PIPE, stderr=log, text=True)
        self._processes.append(process)
        for line in process.stdout:
            for sign, places in (("metrics on ", self.metrics), ("listening on ", self.addresses)):
                if line.startswith(sign):
                    places[name] = line.removeprefix(sign).strip()
            if name in self.metrics and name in self.addresses:
                return
        raise AssertionError(f"{name} did not start: {(self.folder / f'{name}.log').read_text(encoding='utf-8')}")

    def _start_nats(self) -> None:
        text = self._config("nats", "nats.conf").replace("port: 4222", 'listen: "127.0.0.1:-1"')
        text = text.replace('"/data"', f'"{self.folder}/nats"').replace('http: "127.0.0.1:0"', 'http: "127.0.0.1:-1"')
        config = self.folder / "nats.conf"
        config.write_text(text, encoding="utf-8")
        process = subprocess.Popen([NATS, "--config", config], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   text=True, env={**os.environ, "SERVER_NAME": "nats-0"})
        self._processes.append(process)
        said = ""
        for line in process.stderr:
            said += line
            if address := re.search(r"Listening for client connections on (\S+)", line):
                self.addresses["nats-0.nats"] = address[1]
            if "Server is ready" in said and "nats-0.nats" in self.addresses:
                # Read on: a full pipe would hold it up.
                self._readers.append(threading.Thread(target=process.stderr.read))
                self._readers[-1].start()
                return
        raise AssertionError(f"NATS did not start: {said}")
