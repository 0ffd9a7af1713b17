# SPDX-License-Identifier: GPL-3.0-or-later
"""Servers as child processes that are killed, frozen and started again at the same address."""

import os
import re
import shutil
import signal
import socket
import subprocess
import time
import urllib.error
import urllib.request
from pathlib import Path

BIN = Path(os.environ["FLAIR_BIN"])
NATS = shutil.which("nats-server", path=f"{os.environ.get('PATH', '')}:/usr/sbin") or "nats-server"


def _own_host() -> str:
    """An address of this machine for servers of this process alone: what others do at 127.0.0.1 takes no port there."""
    number = os.getpid()
    return f"127.{64 + (number >> 16) % 64}.{number >> 8 & 255}.{number & 255}"


HOST = _own_host()
_given: set[int] = set()


def free_address() -> str:
    """One where nobody listens, given once; a server keeps it over its restarts."""
    while True:
        with socket.socket() as probe:
            probe.bind((HOST, 0))
            port = probe.getsockname()[1]
        if port not in _given:
            _given.add(port)
            return f"{HOST}:{port}"


class Server:
    """One server. What it writes goes to FOLDER/NAME.log, all its lives one after the other."""

    def __init__(self, kind: str, name: str, address: str, command: list[str], folder: Path) -> None:
        self.kind = kind
        self.name = name
        self.address = address
        self.lives = 0
        self._command = command
        self._log = folder / f"{name}.log"
        self._process: subprocess.Popen | None = None
        self._frozen = False

    def start(self) -> None:
        """Starts it and returns at once."""
        self.lives += 1
        with open(self._log, "ab") as log:
            self._process = subprocess.Popen(self._command, stdout=log, stderr=log, stdin=subprocess.DEVNULL)

    def kill(self) -> None:
        """As a power cut does: at once, nothing is cleaned up."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None
            self._frozen = False

    def freeze(self) -> None:
        """It goes on to exist and to be connected, and answers nobody."""
        if self._process is not None:
            self._process.send_signal(signal.SIGSTOP)
            self._frozen = True

    def thaw(self) -> None:
        if self._process is not None and self._frozen:
            self._process.send_signal(signal.SIGCONT)
        self._frozen = False

    def up(self) -> bool:
        """Runs and is not frozen."""
        return self._process is not None and self._process.poll() is None and not self._frozen

    def ended_by_itself(self) -> int | None:
        """The exit code of a life that nobody took."""
        return None if self._process is None else self._process.poll()

    def accepts(self) -> bool:
        """Whether somebody listens at its address."""
        host, port = self.address.rsplit(":", 1)
        try:
            socket.create_connection((host, int(port)), timeout=1).close()
            return True
        except OSError:
            return False

    def wait_until_up(self, seconds: float = 60) -> None:
        """Raises RuntimeError with what it wrote when it does not come up."""
        end = time.monotonic() + seconds
        while not self.accepts():
            if self.ended_by_itself() is not None or time.monotonic() > end:
                raise RuntimeError(f"{self.name} did not start: {self._log.read_text(errors='replace')[-2000:]}")
            time.sleep(0.02)

    def cpu_seconds(self) -> float:
        """Of its present life, in user and system."""
        if self._process is None:
            return 0.0
        try:
            fields = Path(f"/proc/{self._process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            return 0.0
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def memory_bytes(self) -> int:
        """Resident, of its present life."""
        if self._process is None:
            return 0
        try:
            pages = int(Path(f"/proc/{self._process.pid}/statm").read_text().split()[1])
        except OSError:
            return 0
        return pages * os.sysconf("SC_PAGE_SIZE")


class NatsServer(Server):
    """A server of NATS with storage; up when it says that it is healthy, which in a cluster takes the others too."""

    def __init__(self, name: str, address: str, monitor: str, profile: str, config: Path, folder: Path) -> None:
        super().__init__("nats", name, address, [NATS, "--config", str(config)], folder)
        self._monitor = f"http://{monitor}/healthz"
        self._heap = f"http://{profile}/debug/pprof/heap?gc=1&debug=1"

    def healthy(self) -> bool:
        try:
            with urllib.request.urlopen(self._monitor, timeout=2) as answer:
                return answer.status == 200
        except (urllib.error.URLError, OSError):
            return False

    def live_bytes(self) -> int | None:
        """What its heap holds once garbage is collected, which this does; nothing when it does not answer."""
        try:
            with urllib.request.urlopen(self._heap, timeout=10) as answer:
                found = re.search(r"^# HeapAlloc = (\d+)$", answer.read().decode(), re.MULTILINE)
        except (urllib.error.URLError, OSError):
            return None
        return int(found[1]) if found else None
