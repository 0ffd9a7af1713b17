# SPDX-License-Identifier: GPL-3.0-or-later
"""A cluster of real programs on one machine."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from processes import BIN, NatsServer, Server, free_address
from wires import Link, Wires

ENGINES = ("sqlite", "jetstream", "jetstream3")


@dataclass
class Shape:
    """How many of each. NATS servers follow from the engine."""

    engine: str = "sqlite"
    orchestrators: int = 2
    optimizers: int = 2
    optimizer_threads: int = 0  # calls that one works on at once; as many as there are cores when 0
    others: int = 2  # language, translator, renderer: so many of each
    jobs_at_once: int = 4  # of one orchestrator
    lease_seconds: float = 5
    keep_ended_seconds: float = 0  # what has ended is deleted after so long; never when 0
    wired: bool = False  # every orchestrator's connections can be cut


class Cluster:
    """Every server of it, by name. Use it in a `with` block, which starts it and ends it."""

    def __init__(self, folder: Path, shape: Shape) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        self._shape = shape
        self.servers: list[Server] = []
        self.links: list[Link] = []
        self._wires = Wires() if shape.wired else None
        nats_count = {"sqlite": 0, "jetstream": 1, "jetstream3": 3}[shape.engine]
        self._make_nats(nats_count)
        for kind in ("language", "optimizer", "renderer", "translator"):
            count = shape.optimizers if kind == "optimizer" else shape.others
            for i in range(count):
                more = ""
                if kind == "translator":
                    more = f'optimizer_address: "{self.addresses("optimizer")[i % shape.optimizers]}"\n'
                self._make_program(kind, i, more)
        for i in range(shape.orchestrators):
            self._make_program("orchestrator", i, self._orchestrator_config(i, nats_count))

    def __enter__(self) -> "Cluster":
        try:
            self._start()
        except BaseException:
            # Nobody leaves what was not entered.
            self.__exit__()
            raise
        return self

    def _start(self) -> None:
        for kind in ("nats", "language", "optimizer", "renderer", "translator", "orchestrator"):
            members = self.of_kind(kind)
            for server in members:
                server.start()
            for server in members:
                server.wait_until_up()

    def __exit__(self, *_: object) -> None:
        for server in reversed(self.servers):
            server.thaw()
            server.kill()
        if self._wires is not None:
            self._wires.close()

    def of_kind(self, kind: str) -> list[Server]:
        return [server for server in self.servers if server.kind == kind]

    def targets(self, kind: str) -> list[Server | Link]:
        """Servers of the kind, or links of it."""
        return [*self.of_kind(kind), *(link for link in self.links if link.kind == kind)]

    def kinds(self) -> list[str]:
        """Whom a fault may hit."""
        return sorted({target.kind for target in [*self.servers, *self.links]})

    def addresses(self, kind: str) -> list[str]:
        return [server.address for server in self.of_kind(kind)]

    def ended_by_themselves(self) -> Iterator[tuple[Server, int]]:
        """Servers that ended although nobody killed them: a crash is a fault of ours."""
        for server in self.servers:
            if (code := server.ended_by_itself()) is not None:
                yield server, code

    def _make_program(self, kind: str, number: int, more: str) -> None:
        name = f"{kind}_{number}"
        address = free_address()
        config = self._folder / f"{name}.textproto"
        threads = self._shape.optimizer_threads if kind == "optimizer" else 0
        config.write_text(f'runtime {{ listen_address: "{address}" drain_seconds: 5 worker_thread_count: {threads} }}\n{more}')
        self.servers.append(Server(kind, name, address, [str(BIN / f"flair-{kind}"), str(config)], self._folder))

    def _reached(self, orchestrator: int, kind: str, to: str) -> str:
        """Addresses of a kind of server as the orchestrator knows them: those of its wires, where there are any."""
        addresses = self.addresses(kind)
        if self._wires is not None:
            self.links.append(self._wires.lay(f"orchestrator_{orchestrator} to {kind}", f"link to {to}", addresses))
            addresses = self.links[-1].addresses
        return ",".join(addresses)

    def _orchestrator_config(self, number: int, nats_count: int) -> str:
        stages = " ".join(f'{kind}: "{self._reached(number, kind, "workers")}"'
                          for kind in ("language", "translator", "optimizer", "renderer"))
        text = f'store_path: "{self._folder / "store"}"\nstages {{ {stages} }}\n'
        text += f"running_job_limit: {self._shape.jobs_at_once}\nstage_deadline_seconds: 30\n"
        # A worker that is killed all the time is no reason to give up on a job.
        text += "attempt_limit: 100\nstage_calls { recovery_seconds: 0.5 }\n"
        if self._shape.keep_ended_seconds:
            text += f"keep_ended_seconds: {self._shape.keep_ended_seconds}\n"
        if nats_count:
            servers = "nats://" + self._reached(number, "nats", "nats").replace(",", ",nats://")
            text += f'queue {{ address: "{servers}" replica_count: {nats_count} '
            text += f"lease_seconds: {self._shape.lease_seconds} }}\n"
        return text

    def _make_nats(self, count: int) -> None:
        addresses = [[free_address() for _ in range(4)] for _ in range(count)]
        routes = ", ".join(f'"nats://{cluster}"' for *_, cluster in addresses)
        for i, (client, monitor, profile, cluster) in enumerate(addresses):
            name = f"nats_{i}"
            config = self._folder / f"{name}.conf"
            text = f'server_name: {name}\nlisten: "{client}"\nhttp: "{monitor}"\nmax_payload: 4MB\n'
            # At the host of `listen`.
            text += f'prof_port: {profile.rsplit(":", 1)[1]}\n'
            text += f'jetstream {{ store_dir: "{self._folder / name}", max_file_store: 10GB }}\n'
            if count > 1:
                text += f'cluster {{ name: chaos, listen: "{cluster}", routes: [{routes}], no_advertise: true }}\n'
            config.write_text(text)
            self.servers.append(NatsServer(name, client, monitor, profile, config, self._folder))
