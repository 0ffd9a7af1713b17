# SPDX-License-Identifier: GPL-3.0-or-later
"""A batch as a client sees it that believes no single answer: it asks whichever orchestrator answers."""

import threading
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import grpc

from flair import v1

# What every promise of the service says may be tried again.
_PASSING = {grpc.StatusCode.UNAVAILABLE, grpc.StatusCode.DEADLINE_EXCEEDED, grpc.StatusCode.RESOURCE_EXHAUSTED,
            grpc.StatusCode.CANCELLED}
_PER_CALL = 50

BRIEFS = (
    "A bedroom that is 3m x 4m.",
    "A small bathroom.",
    "A home office, 3m by 3m.",
    "A hallway, 1.5m x 4m.",
    "A dining room for four.",
    "A green kitchen that is 3m x 3m.",
)


def spec(index: int) -> v1.JobSpec:
    """The job at a place: quick ones, all different."""
    job = v1.JobSpec(brief=v1.Brief(text=BRIEFS[index % len(BRIEFS)], seed=index))
    job.solve_options.max_restart_count = 2
    job.solve_options.thread_count = 1
    job.render_options.size_px = 256
    return job


class Orchestrators:
    """Calls any of them, one after the other, until one answers."""

    def __init__(self, addresses: list[str], patience_s: float = 180) -> None:
        self._channels = [grpc.insecure_channel(address, [("grpc.max_receive_message_length", 64 << 20),
                                                          ("grpc.initial_reconnect_backoff_ms", 100),
                                                          ("grpc.max_reconnect_backoff_ms", 500)])
                          for address in addresses]
        self._stubs = [v1.OrchestratorServiceStub(channel) for channel in self._channels]
        self._next = 0
        self._patience_s = patience_s

    def close(self) -> None:
        for channel in self._channels:
            channel.close()

    def stub(self) -> v1.OrchestratorServiceStub:
        self._next += 1
        return self._stubs[self._next % len(self._stubs)]

    def ask(self, rpc: str, request: Any) -> Any:
        """Raises the last error when none has answered within the patience, and at once one that does not pass."""
        end = time.monotonic() + self._patience_s
        while True:
            try:
                return getattr(self.stub(), rpc)(request, timeout=10)
            except grpc.RpcError as error:
                if error.code() not in _PASSING or time.monotonic() > end:
                    raise
            time.sleep(0.05)


@dataclass
class Ends:
    """What WatchBatch told."""

    by_job: Counter[str] = field(default_factory=Counter)
    broken_watches: int = 0
    error: str = ""
    done: bool = False


class Batch:
    """A batch of so many jobs: added and watched at the same time, while servers come and go."""

    def __init__(self, orchestrators: Orchestrators, count: int, request_id: str, first_seed: int = 0,
                 spec: Callable[[int], v1.JobSpec] = spec) -> None:
        self._first_seed = first_seed
        self._spec = spec
        self._orchestrators = orchestrators
        self._count = count
        self._request_id = request_id
        self._batch_id = ""
        self._stop = False
        self.ends = Ends()
        self._threads = [threading.Thread(target=self._guard, args=(self._add_then_watch,), daemon=True)]
        for thread in self._threads:
            thread.start()

    @property
    def batch_id(self) -> str:
        return self._batch_id

    def ended_count(self) -> int:
        return len(self.ends.by_job)

    def over(self) -> bool:
        return self.ends.done or bool(self.ends.error)

    def _guard(self, work: Callable[[], None]) -> None:
        try:
            work()
        except grpc.RpcError as error:
            self.ends.error = f"{error.code().name}: {error.details()}"

    def _add_then_watch(self) -> None:
        create = v1.CreateBatchRequest(request_id=self._request_id, open=True, label="chaos")
        self._batch_id = self._orchestrators.ask("CreateBatch", create).batch.id
        watcher = threading.Thread(target=self._guard, args=(self._watch,), daemon=True)
        watcher.start()
        for first in range(0, self._count, _PER_CALL):
            last = min(first + _PER_CALL, self._count)
            request = v1.AddToBatchRequest(batch_id=self._batch_id, first_index=first, last=last == self._count,
                                           specs=[self._spec(self._first_seed + index) for index in range(first, last)])
            self._orchestrators.ask("AddToBatch", request)
        watcher.join()

    def _watch(self) -> None:
        after = 0
        while True:
            request = v1.WatchBatchRequest(batch_id=self._batch_id, after_sequence=after)
            try:
                # A frozen server breaks no connection; a new watch begins where this one ended.
                for response in self._orchestrators.stub().WatchBatch(request, timeout=20):
                    after = response.sequence
                    self.ends.by_job[response.job.id] += 1
                self.ends.done = True
                return
            except grpc.RpcError as error:
                if error.code() not in _PASSING:
                    raise
                self.ends.broken_watches += 1
            time.sleep(0.05)
