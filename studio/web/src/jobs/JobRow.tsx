// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { areaText } from "../app/units";
import { whenText } from "../app/when";
import { JobState, type Job } from "../gen/flair/v1/job_pb";
import { area } from "../geometry/polygon";
import { stageWords } from "../inspector/words";
import { cornersOf } from "../state/pieces";
import { goTo, hashOf } from "../state/route";
import { useStudio } from "../state/studio";
import { cancelJob } from "./cancel";
import type { Facts } from "./facts";
import { JobDetails } from "./JobDetails";
import { editedRoomOf, openResult } from "./open";
import type { JobPictures } from "./pictures";
import { useSeen } from "./seen";
import { failureText, isOpen, stateText, tookText } from "./words";

export const briefOf = (job: Job): string => job.spec?.brief?.text || "A room without a brief";

function aboutOf(job: Job): string {
  if (job.state === JobState.RUNNING && job.stage) return `running: ${stageWords(job.stage).toLowerCase()}`;
  if (job.state === JobState.FAILED) return `failed: ${failureText(job.failureKind)}`;
  return stateText(job.state);
}

// "18 pieces: double bed, desk, nightstand (2), ..."
function Result({ facts: { count, pieces, notDone } }: { facts: Facts }) {
  return (
    <p class="job-result">
      {notDone.length > 0 && (
        <span class="is-warning">{notDone.length} not as asked · </span>
      )}
      {count} {count === 1 ? "piece" : "pieces"}: {pieces.join(", ")}
    </p>
  );
}

export function JobRow({ job, now, changed, pictures }: { job: Job; now: Date; changed(): void; pictures: JobPictures }) {
  const studio = useStudio(), { element, isSeen } = useSeen<HTMLLIElement>();
  const [isBusy, setBusy] = useState(false), [isDetailed, setDetailed] = useState(false);
  const run = (act: () => Promise<unknown>) => {
    setBusy(true);
    void act().finally(() => setBusy(false));
  };
  const cancel = () =>
    run(async () => {
      await cancelJob(studio, job.id);
      changed();
    });
  const isDone = job.state === JobState.SUCCEEDED;
  const facts = isSeen && isDone ? pictures.factsOf(job).value : undefined;
  const edited = isDone ? editedRoomOf(studio.documents.value, job) : undefined;
  const room = job.spec?.brief?.room;
  const about = ["", room && `in a given room of ${areaText(area(cornersOf(room)), studio.settings.units.value)}`,
    whenText(job.createTime, now), tookText(job) && `took ${tookText(job)}`];
  return (
    <li class="job" ref={element}>
      <div class="job-line">
        <span class={`job-state is-${JobState[job.state]!.toLowerCase()}`} aria-hidden="true" />
        <div class="job-text">
          <p class="job-brief" title={briefOf(job)}>
            {briefOf(job)}
          </p>
          <p class="job-about">
            <span class={job.state === JobState.FAILED ? "is-bad" : ""}>{aboutOf(job)}</span>
            {about.filter((text, i) => i === 0 || text).join(" · ")}
            {job.batchId && (
              <>
                {" "}
                · <a href={hashOf({ page: "jobs", id: job.batchId })}>no. {Number(job.batchIndex) + 1} of a batch</a>
              </>
            )}
          </p>
          {facts && <Result facts={facts} />}
          {job.error && <p class="job-error">{job.error}</p>}
        </div>
        <button class="button" aria-expanded={isDetailed} onClick={() => setDetailed(!isDetailed)}>
          <Icon name={isDetailed ? "minus" : "plus"} size={14} />
          Details
        </button>
        {edited && (
          <button
            class="button"
            title="The room that was made of it, as it is now"
            onClick={() => goTo({ page: "document", id: edited.id })}
          >
            Go to its room
          </button>
        )}
        {isDone && (
          <button
            class="button"
            disabled={isBusy}
            title="The room just as the job made it"
            onClick={() => run(() => openResult(studio, job))}
          >
            <Icon name="plan" />
            Open result
          </button>
        )}
        {isOpen(job) && (
          <button class="button" disabled={isBusy} onClick={cancel}>
            <Icon name="close" size={14} />
            Cancel
          </button>
        )}
      </div>
      {isDetailed && <JobDetails job={job} facts={facts} pictures={pictures} />}
    </li>
  );
}
