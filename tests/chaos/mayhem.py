# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, when, and for how long: from a seed."""

import random
import time
from collections import Counter

from cluster import Cluster
from processes import Server
from wires import Link

# One more NATS server down than this, and a cluster of three has no quorum; single ones may be down too.
_NATS_DOWN_LIMIT = 1


class Mayhem:
    """Kills and freezes servers and cuts links, each kind as often as the others, and brings them back.

    Faults come by progress, one for every few jobs that ended, so that slow machines see as many as fast ones; and when
    nothing has ended for a while, by time.
    """

    def __init__(self, cluster: Cluster, seed: int, fault_every: int, longest_s: float, cut_s: float) -> None:
        self._cluster = cluster
        self._random = random.Random(seed)
        self._fault_every = fault_every
        self._longest_s = longest_s
        self._cut_s = cut_s
        self._down: list[tuple[float, Server | Link]] = []  # until when
        self._next_count = 0
        self._last_fault = time.monotonic()
        self.faults: Counter[str] = Counter()  # "kill optimizer": 7

    def step(self, ended_count: int) -> None:
        """Brings back whoever has been away long enough, and maybe takes somebody else down. Call it often."""
        now = time.monotonic()
        for until, server in list(self._down):
            if now >= until:
                self._bring_back(server)
                self._down.remove((until, server))
        if ended_count >= self._next_count or now - self._last_fault > self._longest_s + 2:
            self._next_count = ended_count + self._fault_every
            self._last_fault = now
            self._strike(now)

    def end(self) -> None:
        """Everybody is back."""
        for _, server in self._down:
            self._bring_back(server)
        self._down.clear()

    def _strike(self, now: float) -> None:
        kind = self._random.choice(self._cluster.kinds())
        candidates = [target for target in self._cluster.targets(kind) if target.up()]
        away = self._random.uniform(0, self._longest_s)
        freezes = self._random.random() < 0.25
        victim = self._random.choice(candidates) if candidates else None
        if victim is None or (kind == "nats" and self._nats_down() >= _NATS_DOWN_LIMIT):
            return
        if isinstance(victim, Link):
            victim.freeze()
            away = self._cut_s
        elif freezes:
            victim.freeze()
        else:
            victim.kill()
        what = "cut" if isinstance(victim, Link) else "freeze" if freezes else "kill"
        self.faults[f"{what} {kind}"] += 1
        self._down.append((now + away, victim))

    def _nats_down(self) -> int:
        return sum(not server.up() or not server.healthy() for server in self._cluster.of_kind("nats"))

    @staticmethod
    def _bring_back(server: Server | Link) -> None:
        server.thaw()
        if isinstance(server, Server) and not server.up():
            server.start()
