# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a batch is what it would have been without any fault."""

import time

import grpc

from flair import v1

from batch import Orchestrators

# By place in the batch, then by kind: ids are digests of all that an artifact says.
Artifacts = dict[int, dict[str, str]]


def jobs_of(orchestrators: Orchestrators, batch_id: str) -> list[v1.Job]:
    """All jobs of the batch."""
    jobs, request = [], v1.ListJobsRequest(batch_id=batch_id, page_size=500)
    while True:
        page = orchestrators.ask("ListJobs", request)
        jobs += page.jobs
        if not page.next_page_token:
            return jobs
        request.page_token = page.next_page_token


def artifacts_of(jobs: list[v1.Job]) -> Artifacts:
    """All but the reports, which hold times."""
    return {job.batch_index: {v1.ArtifactKind.Name(ref.kind): ref.id for ref in job.artifacts
                              if ref.kind != v1.ArtifactKind.ARTIFACT_KIND_REPORT} for job in jobs}


def faults_of_batch(orchestrators: Orchestrators, batch_id: str, count: int, told: dict[str, int]) -> list[str]:
    """What is lost, done twice or not told; `told` counts what WatchBatch said of each job."""
    faults = []
    batch = orchestrators.ask("GetBatch", v1.GetBatchRequest(batch_id=batch_id)).batch
    if (batch.job_count, batch.succeeded_count, batch.open_count) != (count, count, 0):
        faults.append(f"the batch counts {batch.job_count} jobs, {batch.succeeded_count} succeeded, "
                      f"{batch.failed_count} failed, {batch.open_count} open; {count} succeeded are right")
    jobs = jobs_of(orchestrators, batch_id)
    if sorted(job.batch_index for job in jobs) != list(range(count)):
        faults.append(f"the batch lists {len(jobs)} jobs at other places than 0 to {count - 1}")
    for job in jobs:
        if job.state != v1.JobState.JOB_STATE_SUCCEEDED:
            faults.append(f"job {job.id} is {v1.JobState.Name(job.state)}: {job.error}")
            continue
        ends = ends_of(orchestrators, job.id)
        if ends != 1:
            faults.append(f"job {job.id} ended {ends} times")
        if told.get(job.id, 0) != 1:
            faults.append(f"the end of job {job.id} was told {told.get(job.id, 0)} times")
    return faults


def ends_of(orchestrators: Orchestrators, job_id: str) -> int:
    """How often the job's own events say that it ended."""
    events = orchestrators.stub().WatchJob(v1.WatchJobRequest(job_id=job_id), timeout=30)
    return sum(response.event.kind == v1.JobEventKind.JOB_EVENT_KIND_ENDED for response in events)


def not_gone(orchestrators: Orchestrators, batch_id: str, keep_s: float) -> list[str]:
    """A batch that ended and is there long after it should have been deleted; waits until it is not."""
    end = time.monotonic() + 2 * keep_s + 60
    while time.monotonic() < end:
        try:
            orchestrators.ask("GetBatch", v1.GetBatchRequest(batch_id=batch_id))
        except grpc.RpcError as error:
            if error.code() == grpc.StatusCode.NOT_FOUND:
                return []
            raise
        time.sleep(0.2)
    return [f"batch {batch_id}, which ended before, is there still"]


def unreadable(orchestrators: Orchestrators, artifacts: Artifacts) -> list[str]:
    """Artifacts that cannot be had, or whose bytes are not what their id says: the server checks that."""
    faults = []
    for artifact_id in sorted({artifact_id for stages in artifacts.values() for artifact_id in stages.values()}):
        artifact = orchestrators.ask("GetArtifact", v1.GetArtifactRequest(artifact_id=artifact_id)).artifact
        if artifact.id != artifact_id:
            faults.append(f"artifact {artifact_id} comes as {artifact.id}")
    return faults


def differences(undisturbed: Artifacts, disturbed: Artifacts) -> list[str]:
    """Where the two differ, artifact by artifact."""
    faults = []
    for index in sorted(undisturbed.keys() | disturbed.keys()):
        ours, theirs = disturbed.get(index, {}), undisturbed.get(index, {})
        for kind in sorted(ours.keys() | theirs.keys()):
            if ours.get(kind) != theirs.get(kind):
                faults.append(f"job {index}: {kind} is {ours.get(kind)}, undisturbed {theirs.get(kind)}")
    return faults
