# SPDX-License-Identifier: GPL-3.0-or-later
"""Connections to servers of Flair, and the client of flair-orchestrator."""

import ipaddress
import time
import uuid
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple, Self

import grpc

from flair import v1
from flair.errors import JobFailed, NotFound, error_of, status_of, turned_away
from flair.events import STAGES, Event, event_of

# A job, or its id.
JobOrId = v1.Job | str
# A batch, or its id.
BatchOrId = v1.Batch | str

# How often a broken stream of events is taken up again without an event in between.
_RECONNECTS = 5
# Jobs that are added to a batch with one call.
_BATCH_PAGE = 200


class Connection:
    """A connection to a server of Flair. Thread-safe; use it in a `with` block or close it.

    Every call raises a FlairError: with a status, a message and, where one is at fault, a field.
    """

    def __init__(
        self,
        address: str,
        *,
        timeout_s: float = 30.0,
        tls: bool | Path = False,
        tls_certificate: tuple[Path, Path] | None = None,
        token: str | Path | None = None,
        allow_insecure: bool = False,
        max_message_mib: int = 32,
    ) -> None:
        """Connects to "HOST:PORT" or "unix:PATH" when the first call is made.

        timeout_s: that every single call may take; watch() waits as long as the job runs unless told otherwise.
        tls: True trusts the system's certificates, a path those of a PEM file; False sends everything as it is.
        tls_certificate: PEM files of an own certificate and its key, for servers that ask for one; means TLS.
        token: who asks, as the orchestrator's tokens say; a path is a file with the token.
        allow_insecure: sends the token as it is, to other machines too.
        """
        limit = max_message_mib << 20
        options = [("grpc.max_receive_message_length", limit), ("grpc.max_send_message_length", limit)]
        if tls or tls_certificate:
            self._channel = grpc.secure_channel(address, _credentials(tls, tls_certificate), options)
        elif token and not allow_insecure and not _is_local(address):
            raise ValueError(f"address: {address} is another machine; a token is not sent there without TLS (tls=...)")
        else:
            self._channel = grpc.insecure_channel(address, options)
        sender = [_TokenSender(_text_of(token))] if token else []
        self._calls = grpc.intercept_channel(self._channel, *sender)
        self._timeout_s = timeout_s

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        self._channel.close()

    def _call(self, method: Callable[..., Any], request: Any, timeout_s: float | None = None) -> Any:
        for pause_s in (0.1, 0.3, 1.0, 3.0, None):
            try:
                return method(request, timeout=timeout_s or self._timeout_s)
            except grpc.RpcError as error:
                if pause_s is None or not turned_away(error):
                    raise error_of(error) from error
            time.sleep(pause_s)


class Client(Connection):
    """A connection to an orchestrator: jobs, batches and what their stages stored."""

    def __init__(self, address: str, **options: Any) -> None:
        super().__init__(address, **options)
        self._stub = v1.OrchestratorServiceStub(self._calls)

    def submit(
        self,
        brief: str | v1.Brief,
        *,
        seed: int | None = None,
        solve_options: v1.SolveOptions | None = None,
        render_options: v1.RenderOptions | None = None,
        model_options: v1.ModelOptions | None = None,
        request_id: str | None = None,
    ) -> v1.Job:
        """Queues a job and returns at once.

        request_id: to be sent again when it is not known whether a first attempt arrived; the job is then the same one.
        """
        spec = v1.JobSpec(solve_options=solve_options, render_options=render_options, model_options=model_options)
        spec.brief.CopyFrom(v1.Brief(text=brief) if isinstance(brief, str) else brief)
        if seed is not None:
            spec.brief.seed = seed
        request = v1.CreateJobRequest(request_id=request_id or str(uuid.uuid4()), spec=spec)
        return self._call(self._stub.CreateJob, request).job

    def job(self, job: JobOrId) -> v1.Job:
        """The job as it is now."""
        return self._call(self._stub.GetJob, v1.GetJobRequest(job_id=_id(job))).job

    def jobs(self) -> Iterator[v1.Job]:
        """All jobs, newest first."""
        request = v1.ListJobsRequest()
        while True:
            page = self._call(self._stub.ListJobs, request)
            yield from page.jobs
            if not page.next_page_token:
                return
            request.page_token = page.next_page_token

    def watch(self, job: JobOrId, *, after: int = 0, timeout_s: float | None = None) -> Iterator[Event]:
        """The job's events, stored ones first, until it ends. Takes up again where a connection broke.

        after: the last event that was seen. Does not raise when the job fails; wait() does.
        """
        breaks = 0
        while True:
            request = v1.WatchJobRequest(job_id=_id(job), after_sequence=after)
            try:
                for response in self._stub.WatchJob(request, timeout=timeout_s):
                    breaks, after = 0, response.event.sequence
                    yield event_of(response.event)
                return
            except grpc.RpcError as error:
                breaks += 1
                if error.code() != grpc.StatusCode.UNAVAILABLE or breaks > _RECONNECTS or not self._is_back(after):
                    raise error_of(error) from error

    def wait(self, job: JobOrId, *, timeout_s: float | None = None) -> v1.Job:
        """The job when it has succeeded. JobFailed when it has not; TimedOut leaves it running."""
        for _ in self.watch(job, timeout_s=timeout_s):
            pass
        ended = self.job(job)
        if ended.state == v1.JobState.JOB_STATE_CANCELLED:
            raise JobFailed(grpc.StatusCode.CANCELLED, "the job was cancelled", ended.id, ended.stage)
        if ended.state == v1.JobState.JOB_STATE_FAILED:
            raise JobFailed(status_of(ended.error_code), ended.error, ended.id, ended.stage)
        return ended

    def cancel(self, job: JobOrId) -> v1.Job:
        """Ends a job; one that has ended stays as it is."""
        return self._call(self._stub.CancelJob, v1.CancelJobRequest(job_id=_id(job))).job

    def submit_batch(
        self, briefs: Iterable[str | v1.Brief | v1.JobSpec], *, label: str = "", request_id: str | None = None
    ) -> v1.Batch:
        """Queues a job for every brief, in their order, and returns when all are queued.

        request_id: to be sent again, with the same briefs, when a first attempt broke off; it then goes on where it was.
        """
        request = v1.CreateBatchRequest(request_id=request_id or str(uuid.uuid4()), label=label, open=True)
        batch = self._call(self._stub.CreateBatch, request).batch
        specs = [_spec(brief) for brief in briefs]
        for first in range(0, max(1, len(specs)), _BATCH_PAGE):
            page = v1.AddToBatchRequest(batch_id=batch.id, first_index=first, last=first + _BATCH_PAGE >= len(specs))
            page.specs.extend(specs[first:first + _BATCH_PAGE])
            batch = self._call(self._stub.AddToBatch, page).batch
        return batch

    def batch(self, batch: BatchOrId) -> v1.Batch:
        """The batch as it is now, with its counts."""
        return self._call(self._stub.GetBatch, v1.GetBatchRequest(batch_id=_id(batch))).batch

    def watch_batch(self, batch: BatchOrId, *, after: int = 0, timeout_s: float | None = None) -> Iterator[v1.Job]:
        """The jobs of a batch as they end, those that have ended already first, until all have.

        Does not raise when a job fails: look at its state.
        """
        request = v1.WatchBatchRequest(batch_id=_id(batch), after_sequence=after)
        try:
            for response in self._stub.WatchBatch(request, timeout=timeout_s):
                yield response.job
        except grpc.RpcError as error:
            raise error_of(error) from error

    def cancel_batch(self, batch: BatchOrId) -> v1.Batch:
        """Ends a batch and all of its jobs."""
        return self._call(self._stub.CancelBatch, v1.CancelBatchRequest(batch_id=_id(batch))).batch

    def fetch(self, job: JobOrId, stage: str) -> v1.Artifact:
        """What a stage of a job has stored, such as "room", "solve" (the layout) or "render" (the picture)."""
        if stage not in STAGES:
            raise ValueError(f'stage: "{stage}" is none; one of {", ".join(STAGES)}')
        stored = {artifact.kind: artifact.id for artifact in self.job(job).artifacts}
        if STAGES[stage] not in stored:
            names = ", ".join(name for name, kind in STAGES.items() if kind in stored) or "nothing"
            raise NotFound(grpc.StatusCode.NOT_FOUND, f'job {_id(job)} has stored {names}, not "{stage}"')
        return self.artifact(stored[STAGES[stage]])

    def artifact(self, artifact_id: str) -> v1.Artifact:
        """An artifact by its id."""
        return self._call(self._stub.GetArtifact, v1.GetArtifactRequest(artifact_id=artifact_id)).artifact

    def _is_back(self, after: int) -> bool:
        """Waits for a server that was there before, as it may be starting again."""
        if after == 0:
            return False
        try:
            grpc.channel_ready_future(self._channel).result(timeout=self._timeout_s)
        except grpc.FutureTimeoutError:
            return False
        return True


class _TokenSender(grpc.UnaryUnaryClientInterceptor, grpc.UnaryStreamClientInterceptor):
    """Sends the token with every call. gRPC's own way asks for TLS, also to one's own machine."""

    def __init__(self, token: str) -> None:
        self._header = ("authorization", f"Bearer {token}")

    def intercept_unary_unary(self, continuation: Callable[..., Any], details: Any, request: Any) -> Any:
        return continuation(self._with_header(details), request)

    def intercept_unary_stream(self, continuation: Callable[..., Any], details: Any, request: Any) -> Any:
        return continuation(self._with_header(details), request)

    def _with_header(self, details: Any) -> "_CallDetails":
        metadata = [*(details.metadata or []), self._header]
        return _CallDetails(details.method, details.timeout, metadata, details.credentials, details.wait_for_ready)


class _CallDetails(NamedTuple):
    """What gRPC's type of this name holds, which cannot be made."""

    method: str
    timeout: float | None
    metadata: list[tuple[str, str]]
    credentials: Any
    wait_for_ready: bool | None


def _credentials(tls: bool | Path, certificate: tuple[Path, Path] | None) -> grpc.ChannelCredentials:
    roots = tls.read_bytes() if isinstance(tls, Path) else None
    chain, key = (path.read_bytes() for path in certificate) if certificate else (None, None)
    return grpc.ssl_channel_credentials(roots, key, chain)


def _text_of(token: str | Path) -> str:
    text = (token.read_text() if isinstance(token, Path) else token).strip()
    if not text or not all("!" <= c <= "~" for c in text):
        raise ValueError("token: expected letters, digits and signs without spaces")
    return text


def _is_local(address: str) -> bool:
    """Whether only this machine can be meant."""
    if address.startswith("unix:"):
        return True
    host = address.removeprefix("dns:///").rpartition(":")[0].strip("[]").lower()
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _id(thing: JobOrId | BatchOrId) -> str:
    return thing if isinstance(thing, str) else thing.id


def _spec(brief: str | v1.Brief | v1.JobSpec) -> v1.JobSpec:
    if isinstance(brief, v1.JobSpec):
        return brief
    return v1.JobSpec(brief=v1.Brief(text=brief) if isinstance(brief, str) else brief)
