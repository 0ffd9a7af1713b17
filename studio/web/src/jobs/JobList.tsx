// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useMemo, useState } from "preact/hooks";
import { JobState } from "../gen/flair/v1/job_pb";
import { useStudio } from "../state/studio";
import { Asked } from "./Asked";
import { JobRow } from "./JobRow";
import { JobPictures } from "./pictures";
import { usePolling } from "./polling";

const kPage = 50;
const kMost = 1000;
const states = [
  [JobState.UNSPECIFIED, "All"],
  [JobState.QUEUED, "Waiting"],
  [JobState.RUNNING, "Running"],
  [JobState.SUCCEEDED, "Done"],
  [JobState.FAILED, "Failed"],
  [JobState.CANCELLED, "Cancelled"],
] as const;

export function StateFilter({ state, take }: { state: JobState; take(state: JobState): void }) {
  return (
    <div class="chips" role="group" aria-label="Jobs in this state">
      {states.map(([one, label]) => (
        <button key={one} class="chip" aria-pressed={one === state} onClick={() => take(one)}>
          {label}
        </button>
      ))}
    </div>
  );
}

export function JobList() {
  const { clients } = useStudio();
  const [state, setState] = useState<JobState>(JobState.UNSPECIFIED),
    [size, setSize] = useState(kPage);
  const asked = usePolling(`${state} ${size}`, () =>
    clients.orchestrator.listJobs({ state, pageSize: size }),
  );
  const { value, again } = asked;
  const pictures = useMemo(() => new JobPictures(clients), [clients]);
  useEffect(() => () => pictures.forgetAll(), [pictures]);
  const now = new Date();
  return (
    <>
      <StateFilter
        state={state}
        take={(one) => {
          setState(one);
          setSize(kPage);
        }}
      />
      <Asked of={asked} />
      {value?.jobs.length === 0 && (
        <p class="jobs-empty">{state === JobState.UNSPECIFIED ? "Nothing has been designed yet." : "No such job."}</p>
      )}
      <ul class="job-list">
        {value?.jobs.map((job) => (
          <JobRow key={job.id} job={job} now={now} changed={again} pictures={pictures} />
        ))}
      </ul>
      {value?.nextPageToken && size < kMost && (
        <button class="button jobs-more" onClick={() => setSize(Math.min(size + 100, kMost))}>
          Show more
        </button>
      )}
    </>
  );
}
