# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens in the life of a job."""

from dataclasses import dataclass

from flair import v1

# What each stage stores, in the order in which they run.
STAGES = {
    "brief": v1.ArtifactKind.ARTIFACT_KIND_BRIEF,
    "room": v1.ArtifactKind.ARTIFACT_KIND_ROOM,
    "zones": v1.ArtifactKind.ARTIFACT_KIND_ZONE_PLAN,
    "objects": v1.ArtifactKind.ARTIFACT_KIND_OBJECT_LIST,
    "style": v1.ArtifactKind.ARTIFACT_KIND_STYLE_SHEET,
    "constraints": v1.ArtifactKind.ARTIFACT_KIND_RAW_CONSTRAINT_LIST,
    "cleaning": v1.ArtifactKind.ARTIFACT_KIND_CONSTRAINT_LIST,
    "completion": v1.ArtifactKind.ARTIFACT_KIND_COMPLETED_CONSTRAINT_LIST,
    "translation": v1.ArtifactKind.ARTIFACT_KIND_LAYOUT_GRAPH,
    "solve": v1.ArtifactKind.ARTIFACT_KIND_SOLVED_LAYOUT,
    "render": v1.ArtifactKind.ARTIFACT_KIND_PREVIEW,
    "report": v1.ArtifactKind.ARTIFACT_KIND_REPORT,
}


@dataclass(frozen=True)
class Event:
    """One step."""

    sequence: int
    """Counts up from 1 within the job."""
    kind: str
    """"stage_started", "stage_finished", "stage_reused" or "ended"."""
    stage: str
    """A key of STAGES; empty for events of the whole job."""
    message: str
    """What was found or went wrong, for people."""
    duration_s: float
    artifact_id: str
    """What the stage stored; empty when nothing."""
    state: str
    """Where the job stands after it: "queued", "running", "succeeded", "failed" or "cancelled"."""


def event_of(event: v1.JobEvent) -> Event:
    return Event(
        sequence=event.sequence,
        kind=v1.JobEventKind.Name(event.kind).removeprefix("JOB_EVENT_KIND_").lower(),
        stage=event.stage,
        message=event.message,
        duration_s=event.duration.seconds + event.duration.nanos * 1e-9,
        artifact_id=event.artifact.id,
        state=v1.JobState.Name(event.state).removeprefix("JOB_STATE_").lower(),
    )
