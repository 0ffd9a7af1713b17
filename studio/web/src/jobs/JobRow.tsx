// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { whenText } from "../app/when";
import { JobState, type Job } from "../gen/flair/v1/job_pb";
import { stageWords } from "../inspector/words";
import { goTo, hashOf } from "../state/route";
import { useStudio, type Studio } from "../state/studio";
import { failureText, isOpen, stateText, tookText } from "./words";

// The job's room as a document: the one that it was made for, or a new one.
export async function openJob(studio: Studio, job: Job): Promise<void> {
  const known = studio.documents.peek().find(({ jobId }) => jobId === job.id);
  if (known) return goTo({ page: "document", id: known.id });
  await studio.create({ case: "jobId", value: job.id });
}

export const briefOf = (job: Job): string => job.spec?.brief?.text || "A room without a brief";

function aboutOf(job: Job): string {
  if (job.state === JobState.RUNNING && job.stage) return `running: ${stageWords(job.stage).toLowerCase()}`;
  if (job.state === JobState.FAILED) return `failed: ${failureText(job.failureKind)}`;
  return stateText(job.state);
}

export function JobRow({ job, now, changed }: { job: Job; now: Date; changed(): void }) {
  const studio = useStudio(),
    [isBusy, setBusy] = useState(false);
  const run = (act: () => Promise<unknown>) => {
    setBusy(true);
    void act().finally(() => setBusy(false));
  };
  const cancel = () =>
    run(async () => {
      await studio.told(() => studio.clients.orchestrator.cancelJob({ jobId: job.id }));
      changed();
    });
  return (
    <li class="job">
      <span class={`job-state is-${JobState[job.state]!.toLowerCase()}`} aria-hidden="true" />
      <div class="job-text">
        <p class="job-brief" title={briefOf(job)}>
          {briefOf(job)}
        </p>
        <p class="job-about">
          <span class={job.state === JobState.FAILED ? "is-bad" : ""}>{aboutOf(job)}</span>
          {["", whenText(job.createTime, now), tookText(job)].filter((text, i) => i === 0 || text).join(" · ")}
          {job.batchId && (
            <>
              {" "}
              · <a href={hashOf({ page: "jobs", id: job.batchId })}>no. {Number(job.batchIndex) + 1} of a batch</a>
            </>
          )}
        </p>
        {job.error && <p class="job-error">{job.error}</p>}
      </div>
      {job.state === JobState.SUCCEEDED && (
        <button class="button" disabled={isBusy} onClick={() => run(() => openJob(studio, job))}>
          <Icon name="plan" />
          Open
        </button>
      )}
      {isOpen(job) && (
        <button class="button" disabled={isBusy} onClick={cancel}>
          <Icon name="close" size={14} />
          Cancel
        </button>
      )}
    </li>
  );
}
