// SPDX-License-Identifier: GPL-3.0-or-later
import { useMemo } from "preact/hooks";
import { whenText } from "../app/when";
import type { Batch } from "../gen/flair/v1/orchestrator_service_pb";
import { hashOf } from "../state/route";
import { useStudio } from "../state/studio";
import { Asked } from "./Asked";
import { BatchBar, BatchButtons, BatchFailures, batchTitle, countsOf } from "./BatchHead";
import { usePolling } from "./polling";
import { batchText } from "./words";

export function BatchList() {
  const { clients } = useStudio();
  // ListBatches counts no states: batches that have not ended are asked for again, ended ones once.
  const ended = useMemo(() => new Map<string, Batch>(), []);
  const asked = usePolling("batches", async () => {
    const { batches } = await clients.orchestrator.listBatches({});
    const full: Batch[] = [];
    for (const { id } of batches) {
      const known = ended.get(id);
      const batch = known ?? (await clients.orchestrator.getBatch({ batchId: id })).batch;
      if (!batch) continue;
      if (batch.openCount === 0 && !batch.open) ended.set(id, batch);
      full.push(batch);
    }
    return full;
  });
  const { value, again } = asked;
  const now = new Date();
  return (
    <>
      <Asked of={asked} />
      {value?.length === 0 && (
        <p class="jobs-empty">
          No batches. A file of briefs becomes one with <code>flair batch</code>.
        </p>
      )}
      <ul class="batch-list">
        {value?.map((batch) => (
          <li key={batch.id} class="batch">
            <div class="batch-line">
              <a class="batch-title" href={hashOf({ page: "jobs", id: batch.id })}>
                {batchTitle(batch)}
              </a>
              <span class="batch-state">
                {batchText(batch)} · {whenText(batch.createTime, now)}
              </span>
            </div>
            <BatchBar batch={batch} />
            <div class="batch-line">
              <span class="batch-counts">{countsOf(batch)}</span>
              <BatchButtons
                batch={batch}
                changed={() => {
                  ended.delete(batch.id);
                  again();
                }}
              />
            </div>
            <BatchFailures batch={batch} />
          </li>
        ))}
      </ul>
    </>
  );
}
