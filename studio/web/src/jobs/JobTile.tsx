// SPDX-License-Identifier: GPL-3.0-or-later
// A job of a batch as a small plan; what it shows is fetched when it comes into view.
import { useEffect, useRef, useState } from "preact/hooks";
import { JobState, type Job } from "../gen/flair/v1/job_pb";
import { useStudio } from "../state/studio";
import { briefOf, openJob } from "./JobRow";
import type { Measures } from "./measures";
import type { JobPictures } from "./pictures";
import { failureText, stateText } from "./words";

function figures(measures: Measures | undefined): string {
  const share = (name: string, value: number | undefined) =>
    value === undefined ? "" : `${name} ${Math.round(value * 100)}`;
  const texts = [share("held", measures?.held), share("uses", measures?.uses), share("floor", measures?.floor)].filter(
    Boolean,
  );
  return texts.length > 0 ? `${texts.join(" · ")}\u00a0%` : "";
}

export function JobTile({ job, pictures }: { job: Job; pictures: JobPictures }) {
  const studio = useStudio(),
    tile = useRef<HTMLLIElement>(null);
  const [isSeen, setSeen] = useState(false);
  useEffect(() => {
    const observer = new IntersectionObserver(
      ([entry]) => {
        if (entry!.isIntersecting) setSeen(true);
      },
      { rootMargin: "200px" },
    );
    observer.observe(tile.current!);
    return () => observer.disconnect();
  }, []);
  const isDone = job.state === JobState.SUCCEEDED;
  const plan = isSeen && isDone ? pictures.planOf(job).value : undefined;
  const measures = isSeen && isDone ? pictures.measuresOf(job).value : undefined;
  return (
    <li class="tile" ref={tile}>
      <button disabled={!isDone} onClick={() => void openJob(studio, job)} title={isDone ? "Open it" : job.error}>
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
        <span class="tile-measures">
          {isDone ? figures(measures) : job.error || `no. ${Number(job.batchIndex) + 1}`}
        </span>
      </button>
    </li>
  );
}
