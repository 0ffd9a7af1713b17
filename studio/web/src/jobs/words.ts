// SPDX-License-Identifier: GPL-3.0-or-later
// States, failures and times of jobs in words.
import { timestampDate, type Duration, type Timestamp } from "@bufbuild/protobuf/wkt";
import { FailureKind, JobState, type Job } from "../gen/flair/v1/job_pb";
import { BatchState, WorkerState, type Batch } from "../gen/flair/v1/orchestrator_service_pb";

const failures: Record<FailureKind, string> = {
  [FailureKind.UNSPECIFIED]: "failed",
  [FailureKind.INPUT]: "brief or options",
  [FailureKind.LANGUAGE]: "the design",
  [FailureKind.TRANSLATION]: "measuring the wishes",
  [FailureKind.INFEASIBLE]: "does not fit",
  [FailureKind.WORKER]: "a worker program",
  [FailureKind.TIMEOUT]: "took too long",
  [FailureKind.STORE]: "storing it",
};

export const failureText = (kind: FailureKind): string => failures[kind] ?? "failed";

const states: Record<JobState, string> = {
  [JobState.UNSPECIFIED]: "",
  [JobState.QUEUED]: "waiting",
  [JobState.RUNNING]: "running",
  [JobState.SUCCEEDED]: "done",
  [JobState.FAILED]: "failed",
  [JobState.CANCELLED]: "cancelled",
};

export const stateText = (state: JobState): string => states[state] ?? "";
export const isOpen = ({ state }: Job): boolean => state === JobState.QUEUED || state === JobState.RUNNING;
export const endedCount = ({ jobCount, openCount }: Batch): number => jobCount - openCount;

// Nothing of it runs though it may: others are before it, or the program that ran it has ended.
export const isWaiting = ({ state, openCount, runningCount }: Batch): boolean =>
  state === BatchState.ACTIVE && openCount > 0 && runningCount === 0;

export function batchText(batch: Batch): string {
  if (batch.state === BatchState.PAUSED) return "paused";
  if (batch.state === BatchState.CANCELLED) return "cancelled";
  if (batch.open) return "more follow";
  if (isWaiting(batch)) return "waiting";
  return batch.openCount > 0 ? "running" : "done";
}

export const workerText = (state: WorkerState): string =>
  (
    ({ [WorkerState.READY]: "ready", [WorkerState.BROKEN]: "broken", [WorkerState.GONE]: "gone" }) as Partial<
      Record<WorkerState, string>
    >
  )[state] ?? "idle";

export const seconds = (duration: Duration | undefined): number =>
  duration ? Number(duration.seconds) + duration.nanos / 1e9 : 0;

// "0.42 s", "1 m 05 s", "2 h 03 m".
export function lastingText(total: number): string {
  if (total < 0.9995) return total > 0 ? `${Math.max(1, Math.round(total * 1000))} ms` : "0 s";
  if (total < 60) return `${total.toFixed(1)} s`;
  const whole = Math.floor(total),
    pad = (n: number) => String(n).padStart(2, "0");
  if (whole < 3600) return `${Math.floor(whole / 60)} m ${pad(whole % 60)} s`;
  return `${Math.floor(whole / 3600)} h ${pad(Math.floor(whole / 60) % 60)} m`;
}

export function tookText({ createTime, endTime }: Job): string {
  if (!createTime || !endTime) return "";
  return lastingText((timestampDate(endTime).getTime() - timestampDate(createTime).getTime()) / 1000);
}

export const age = (time: Timestamp | undefined, now: number): number =>
  time ? Math.max(0, (now - timestampDate(time).getTime()) / 1000) : 0;

export const count = (number: number | bigint): string => number.toLocaleString("en");
