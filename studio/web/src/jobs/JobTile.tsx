// SPDX-License-Identifier: GPL-3.0-or-later
// A job of a batch as a small plan; what it shows is fetched when it comes into view.
import { JobState, type Job } from "../gen/flair/v1/job_pb";
import { useStudio } from "../state/studio";
import { briefOf } from "./JobRow";
import { openResult } from "./open";
import { percent } from "../inspector/words";
import { measureNames, type MeasureName, type Measures } from "./measures";
import type { JobPictures } from "./pictures";
import { useSeen } from "./seen";
import { failureText, stateText } from "./words";

const short: Record<MeasureName, string> = { held: "wishes", uses: "use", floor: "floor" };

// "wishes 95 · use 90 · floor 100 %", and in full for its title.
function figures(measures: Measures): { text: string; title: string } {
  const known = (Object.keys(short) as MeasureName[]).flatMap((name) => {
    const share = measures[name];
    return share === undefined ? [] : [{ name, text: percent(share) }];
  });
  return {
    text: known.map(({ name, text }) => `${short[name]} ${text}`).join(" · "),
    title: known.map(({ name, text }) => `${measureNames[name].label}: ${text}`).join("\n"),
  };
}

export function JobTile({ job, pictures }: { job: Job; pictures: JobPictures }) {
  const studio = useStudio(), { element, isSeen } = useSeen<HTMLLIElement>();
  const isDone = job.state === JobState.SUCCEEDED;
  const plan = isSeen && isDone ? pictures.planOf(job).value : undefined;
  const measures = isSeen && isDone ? pictures.measuresOf(job).value : undefined;
  const shown = figures(measures ?? {});
  return (
    <li class="tile" ref={element}>
      <button disabled={!isDone} onClick={() => void openResult(studio, job)} title={isDone ? "Open it" : job.error}>
        <span class="tile-picture">
          {plan && <img src={plan} alt="" loading="lazy" />}
          {!plan && (
            <span class={job.state === JobState.FAILED ? "tile-state is-bad" : "tile-state"}>
              {job.state === JobState.FAILED
                ? failureText(job.failureKind)
                : isDone
                  ? plan === ""
                    ? "no plan drawn"
                    : ""
                  : stateText(job.state)}
            </span>
          )}
        </span>
        <span class="tile-brief">{briefOf(job)}</span>
        <span class="tile-measures" title={shown.title}>
          {isDone ? shown.text : job.error || `no. ${Number(job.batchIndex) + 1}`}
        </span>
      </button>
    </li>
  );
}
