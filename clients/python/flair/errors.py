# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, as exceptions."""

import re

import grpc

_FIELD = re.compile(r"((?:[a-z_][a-z0-9_]*(?:\[\d+\])?)(?:\.[a-z_][a-z0-9_]*(?:\[\d+\])?)*): ")


class FlairError(Exception):
    """A call or a job that failed. Subclasses exist for what callers treat differently."""

    def __init__(self, status: grpc.StatusCode, message: str) -> None:
        super().__init__(f"{status.name}: {message}")
        self.status = status
        self.message = message
        """One sentence: the field and its value where there is one, and what would be right."""
        found = _FIELD.match(message)
        self.field: str | None = found[1] if found else None
        """Path of the field at fault, such as "spec.brief.text"; None when no field is."""


class InvalidRequest(FlairError):
    """Something asked for cannot be; `field` says what."""


class NotFound(FlairError):
    """No such job or artifact."""


class AlreadyExists(FlairError):
    """The request_id was used for another job."""


class Busy(FlairError):
    """The queue is full; the same call may be made again later."""


class Unavailable(FlairError):
    """Nobody answers at the address; the same call may be made again later."""


class TimedOut(FlairError):
    """No answer in time. A job goes on nevertheless."""


class JobFailed(FlairError):
    """A job ended without a result, or was cancelled (status CANCELLED)."""

    def __init__(self, status: grpc.StatusCode, message: str, job_id: str, stage: str) -> None:
        super().__init__(status, message)
        self.job_id = job_id
        self.stage = stage
        """Where it ended, such as "room"."""


_CLASSES = {
    grpc.StatusCode.INVALID_ARGUMENT: InvalidRequest,
    grpc.StatusCode.NOT_FOUND: NotFound,
    grpc.StatusCode.ALREADY_EXISTS: AlreadyExists,
    grpc.StatusCode.RESOURCE_EXHAUSTED: Busy,
    grpc.StatusCode.UNAVAILABLE: Unavailable,
    grpc.StatusCode.DEADLINE_EXCEEDED: TimedOut,
}
_STATUS = {status.value[0]: status for status in grpc.StatusCode}


def error_of(error: grpc.RpcError) -> FlairError:
    """The exception for a call that failed."""
    return _CLASSES.get(error.code(), FlairError)(error.code(), error.details() or "no reason given")


def turned_away(error: grpc.RpcError) -> bool:
    """Whether a server that is there did not take the call: it had no room for so large a message, or was stopping."""
    return error.details() in (
        "Received RST_STREAM with error code 11",
        "the server has no room for so large a message at the moment; try again later",
        "GOAWAY received",
    )


def status_of(code: int) -> grpc.StatusCode:
    """The status of a gRPC code."""
    return _STATUS.get(code, grpc.StatusCode.UNKNOWN)
