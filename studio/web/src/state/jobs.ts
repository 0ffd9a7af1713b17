// SPDX-License-Identifier: GPL-3.0-or-later
// How far the jobs of documents are, as their events tell.
import { signal } from "@preact/signals";
import type { JobEvent } from "../gen/flair/v1/job_pb";
import { JobEventKind, JobState } from "../gen/flair/v1/job_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";

export interface StageProgress {
  readonly stage: string;
  readonly message: string;
  readonly seconds: number;
  readonly isDone: boolean;
  readonly isReused: boolean;
}

// Whether a job designs or furnishes it just now.
export const isWorking = ({ jobState }: Document): boolean => jobState === JobState.QUEUED || jobState === JobState.RUNNING;

// Events in order of arrival -> stages in the order in which they began.
export function stagesOf(events: readonly JobEvent[]): StageProgress[] {
  const stages = new Map<string, StageProgress>();
  for (const { kind, stage, message, duration } of events) {
    if (!stage) continue;
    const before = stages.get(stage);
    const isDone = kind === JobEventKind.STAGE_FINISHED || kind === JobEventKind.STAGE_REUSED;
    if (before?.isDone && !isDone) continue;
    const seconds = duration ? Number(duration.seconds) + duration.nanos / 1e9 : 0;
    stages.set(stage, { stage, message, seconds, isDone, isReused: kind === JobEventKind.STAGE_REUSED });
  }
  return [...stages.values()];
}

export class JobBook {
  readonly events = signal<ReadonlyMap<string, readonly JobEvent[]>>(new Map());

  add(event: JobEvent): void {
    const known = this.events.value.get(event.jobId) ?? [];
    if (known.some((one) => one.sequence === event.sequence)) return;
    this.events.value = new Map(this.events.value).set(event.jobId, [...known, event]);
  }
}
