// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a job as they come.
import { Icon } from "../app/Icon";
import { JobState } from "../gen/flair/v1/job_pb";
import { spentInWords, useSpent } from "../model/spent";
import { stageWords } from "../inspector/words";
import { cancelJob } from "../jobs/cancel";
import { isWorking, stagesOf } from "../state/jobs";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import { firstBrief } from "./first_brief";

// Begins with what was asked, to be changed.
function another(text: string): void {
  firstBrief.value = text;
  goTo({ page: "start" });
}

export function Progress({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const { jobId, jobState, jobError, title, brief } = room.document.value;
  const events = studio.jobs.events.value.get(jobId) ?? [];
  const stages = stagesOf(events);
  const spent = useSpent(studio.clients, events);
  const isFailed = jobState === JobState.FAILED || jobState === JobState.CANCELLED;
  return (
    <div class="progress" aria-live="polite">
      <h1>{title}</h1>
      <ol class="stages">
        {stages.map(({ stage, message, seconds, isDone, isReused }) => (
          <li key={stage} class={isDone ? "is-done" : "is-running"}>
            <span class="stage-mark">{isDone ? <Icon name="check" size={14} /> : <span class="spinner" />}</span>
            <span class="stage-name">{stageWords(stage)}</span>
            <span class="stage-message">{message}</span>
            <span class="stage-time">{isReused ? "known" : isDone ? `${seconds.toFixed(2)} s` : ""}</span>
          </li>
        ))}
        {stages.length === 0 && !isFailed && (
          <li class="is-running">
            <span class="stage-mark">
              <span class="spinner" />
            </span>
            <span class="stage-name">Starting</span>
          </li>
        )}
      </ol>
      {isWorking(room.document.value) && (
        <button class="button" onClick={() => cancelJob(studio, jobId)}>Cancel</button>
      )}
      {spent.calls > 0 && <p class="hint spent">The model: {spentInWords(spent)}</p>}
      {isFailed && (
        <div class="notice is-bad" role="alert">
          <p>{jobError || "The design was ended."}</p>
          <button class="button" onClick={() => another(brief?.text ?? "")}>Try another brief</button>
        </div>
      )}
    </div>
  );
}
