# SPDX-License-Identifier: GPL-3.0-or-later
"""A gRPC server that behaves as Flair's own programs do."""

import hashlib
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import grpc

from flair import v1
from flair.stage import health_pb2_grpc, reflection_pb2_grpc
from flair.stage.health import Health
from flair.stage.reflection import Reflection

# As many calls are worked on at once; more are refused with RESOURCE_EXHAUSTED, which callers try again.
CALL_LIMIT = 64
MESSAGE_LIMIT_BYTES = 32 << 20
DRAIN_S = 10.0

WORKER_SERVICE = "flair.v1.WorkerService"


@dataclass(frozen=True)
class Stage:
    """What is served."""

    worker: v1.GetWorkerResponse
    """What the program says of itself; its revision must change whenever its answers may."""
    service: str
    """Full name, such as "flair.v1.OptimizerService"."""
    register: Callable[[grpc.Server], None]
    """Adds the servicer to the server."""


def digest_of(paths: list[Path]) -> str:
    """SHA-256 in hex of files, each with its name and that of its folder, in whatever order they are given."""
    digest = hashlib.sha256()
    for path in sorted(paths):
        content = path.read_bytes()
        digest.update(f"{path.parent.name}/{path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


class _Worker(v1.WorkerServiceServicer):
    def __init__(self, worker: v1.GetWorkerResponse) -> None:
        self._worker = worker

    def GetWorker(self, request: v1.GetWorkerRequest, context: grpc.ServicerContext) -> v1.GetWorkerResponse:
        return self._worker


def serve(stage: Stage, listen_address: str) -> None:
    """Serves stage, health, reflection and WorkerService until SIGTERM or SIGINT, then lets running calls end.

    Prints the address with the port that was taken. Exits the process with 1 when it cannot listen there.
    """
    services = [stage.service, WORKER_SERVICE, "grpc.health.v1.Health", "grpc.reflection.v1alpha.ServerReflection"]
    options = [
        ("grpc.max_receive_message_length", MESSAGE_LIMIT_BYTES),
        ("grpc.max_send_message_length", MESSAGE_LIMIT_BYTES),
        ("grpc.so_reuseport", 0),  # otherwise a second program could take the same port unnoticed
    ]
    server = grpc.server(ThreadPoolExecutor(CALL_LIMIT), options=options, maximum_concurrent_rpcs=CALL_LIMIT)
    health = Health(services)
    stage.register(server)
    v1.add_WorkerServiceServicer_to_server(_Worker(stage.worker), server)
    health_pb2_grpc.add_HealthServicer_to_server(health, server)
    reflection_pb2_grpc.add_ServerReflectionServicer_to_server(Reflection(services), server)
    try:
        port = server.add_insecure_port(listen_address)
    except RuntimeError:
        port = 0
    if port == 0:
        sys.exit(f"{stage.worker.program}: cannot listen on {listen_address}: in use, or no address of this machine")
    stop = threading.Event()
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: stop.set())
    server.start()
    print(f"listening on {listen_address.rpartition(':')[0]}:{port}", flush=True)
    stop.wait()
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, signal.SIG_DFL)  # a second one ends the process at once
    health.stop()
    server.stop(DRAIN_S).wait()
