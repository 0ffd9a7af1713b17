// SPDX-License-Identifier: GPL-3.0-or-later
// How far a batch is, and what one can do to it.
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { BatchState, type Batch } from "../gen/flair/v1/orchestrator_service_pb";
import { useStudio } from "../state/studio";
import { percent } from "../inspector/words";
import { count, endedCount, failureText, isWaiting } from "./words";

export function BatchBar({ batch }: { batch: Batch }) {
  const all = Math.max(batch.jobCount, 1);
  let at = 0;
  const part = (name: string, jobs: number) => {
    const x = (at / all) * 100,
      width = (jobs / all) * 100;
    at += jobs;
    return jobs > 0 ? <rect key={name} class={`bar-${name}`} x={x} y={0} width={width} height={6} /> : null;
  };
  return (
    <svg
      class="batch-bar"
      viewBox="0 0 100 6"
      preserveAspectRatio="none"
      role="img"
      aria-label={`${percent(endedCount(batch) / all)} ended`}
    >
      <rect class="bar-ground" width={100} height={6} />
      {part("done", batch.succeededCount)}
      {part("failed", batch.failedCount)}
      {part("cancelled", batch.cancelledCount)}
      {part("running", batch.runningCount)}
    </svg>
  );
}

export function countsOf(batch: Batch): string {
  return [
    `${count(endedCount(batch))} of ${count(batch.jobCount)} ended`,
    batch.runningCount > 0 && `${count(batch.runningCount)} running`,
    batch.failedCount > 0 && `${count(batch.failedCount)} failed`,
    batch.cancelledCount > 0 && `${count(batch.cancelledCount)} cancelled`,
  ]
    .filter(Boolean)
    .join(" · ");
}

export function BatchButtons({ batch, changed }: { batch: Batch; changed(): void }) {
  const studio = useStudio(),
    call = studio.clients.orchestrator,
    [isBusy, setBusy] = useState(false);
  const batchId = batch.id,
    isCancelled = batch.state === BatchState.CANCELLED;
  const run = (act: () => Promise<unknown>) => {
    setBusy(true);
    void studio.told(act).finally(() => {
      setBusy(false);
      changed();
    });
  };
  const retry = () =>
    run(async () => {
      const { retriedCount } = await call.retryBatch({ batchId });
      studio.toasts.note(`${count(retriedCount)} ${retriedCount === 1n ? "job waits" : "jobs wait"} again.`);
    });
  return (
    <div class="batch-buttons">
      {batch.state === BatchState.ACTIVE && batch.openCount > 0 && (
        <button class="button" disabled={isBusy} onClick={() => run(() => call.pauseBatch({ batchId }))}>
          <Icon name="pause" />
          Pause
        </button>
      )}
      {(batch.state === BatchState.PAUSED || isWaiting(batch)) && (
        <button class="button" disabled={isBusy} onClick={() => run(() => call.resumeBatch({ batchId }))}>
          <Icon name="play" />
          Resume
        </button>
      )}
      {batch.failedCount > 0 && !isCancelled && (
        <button class="button" disabled={isBusy} onClick={retry}>
          <Icon name="redo" />
          Retry failed
        </button>
      )}
      {!isCancelled && (batch.openCount > 0 || batch.open) && (
        <button class="button" disabled={isBusy} onClick={() => run(() => call.cancelBatch({ batchId }))}>
          <Icon name="close" size={14} />
          Cancel
        </button>
      )}
    </div>
  );
}

export function BatchFailures({ batch }: { batch: Batch }) {
  if (batch.failures.length === 0) return null;
  return (
    <p class="batch-failures">
      Failed: {batch.failures.map(({ kind, jobCount }) => `${failureText(kind)} ${count(jobCount)}`).join(" · ")}
    </p>
  );
}

export const batchTitle = (batch: Batch): string => batch.label || batch.id;
