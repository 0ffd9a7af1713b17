# SPDX-License-Identifier: GPL-3.0-or-later
"""grpc.health.v1.Health: whether a server and each of its services take calls."""

import threading
from collections.abc import Iterator

import grpc

from flair.stage import health_pb2, health_pb2_grpc


class Health(health_pb2_grpc.HealthServicer):
    """Knows the services by full name and the whole server as "". Thread-safe."""

    def __init__(self, services: list[str]) -> None:
        self._services = {"", *services}
        self._status = health_pb2.HealthCheckResponse.SERVING
        self._changed = threading.Condition()

    def stop(self) -> None:
        """Says NOT_SERVING from now on, and ends every Watch with it."""
        with self._changed:
            self._status = health_pb2.HealthCheckResponse.NOT_SERVING
            self._changed.notify_all()

    def _status_of(self, service: str) -> int:
        return self._status if service in self._services else health_pb2.HealthCheckResponse.SERVICE_UNKNOWN

    def Check(
        self, request: health_pb2.HealthCheckRequest, context: grpc.ServicerContext
    ) -> health_pb2.HealthCheckResponse:
        if request.service not in self._services:
            context.abort(grpc.StatusCode.NOT_FOUND, f"service: \"{request.service}\" is not served here")
        return health_pb2.HealthCheckResponse(status=self._status)

    def Watch(
        self, request: health_pb2.HealthCheckRequest, context: grpc.ServicerContext
    ) -> Iterator[health_pb2.HealthCheckResponse]:
        yield health_pb2.HealthCheckResponse(status=self._status_of(request.service))
        with self._changed:
            while context.is_active() and self._status == health_pb2.HealthCheckResponse.SERVING:
                self._changed.wait(timeout=1)  # a caller that left is noticed within a second
        yield health_pb2.HealthCheckResponse(status=self._status_of(request.service))
